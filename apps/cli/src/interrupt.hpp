// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stop_token>
#include <thread>

namespace twum::cli {

/// The first Ctrl-C (or SIGTERM) sets a flag, so that work in progress can be finished and written. If that takes
/// longer than 0.8 s, the program exits with kInterrupted. A second signal ends it at once. A closed pipe or a file
/// size limit becomes an error of the write.
void install_interrupt_handler();

/// Ignores Ctrl-C and SIGTERM, because another process handles them and ends this one.
void ignore_interrupts();

/// True once the program was asked to stop.
bool interrupted() noexcept;

/// Provides a stop token during its lifetime. A stop is requested soon after the program was asked to stop.
class StopOnInterrupt {
 public:
  StopOnInterrupt();
  std::stop_token token() const { return source_.get_token(); }

 private:
  std::stop_source source_;
  std::jthread watcher_;
};

}  // namespace twum::cli
