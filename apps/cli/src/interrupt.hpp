// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stop_token>
#include <thread>

namespace twum::cli {

/// The first Ctrl-C (or SIGTERM) sets a flag, so that what is in flight can be finished and written. What
/// has not come to its end 0.8 s later is ended: the program exits with kInterrupted, wherever it is. A
/// second signal ends it at once. A closed pipe or a file size limit becomes an error of the write.
void install_interrupt_handler();

/// Leaves Ctrl-C and SIGTERM to another process, which ends this one when it has finished.
void ignore_interrupts();

/// True once the program was asked to stop.
bool interrupted() noexcept;

/// A stop token for as long as it lives, requested soon after the program was asked to stop.
class StopOnInterrupt {
 public:
  StopOnInterrupt();
  std::stop_token token() const { return source_.get_token(); }

 private:
  std::stop_source source_;
  std::jthread watcher_;
};

}  // namespace twum::cli
