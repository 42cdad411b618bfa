// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <stop_token>
#include <thread>

namespace twum::inline v0_1::cli {

/// The first Ctrl-C (or SIGTERM) sets a flag, so that work in progress can be finished and written. If that takes
/// longer than 0.8 s, the program exits with kInterrupted. A second signal ends it at once. A closed pipe or a file
/// size limit becomes an error of the write.
void install_interrupt_handler();

/// Ignores Ctrl-C and SIGTERM, because another process handles them and ends this one.
void ignore_interrupts();

/// True once the program was asked to stop.
bool interrupted() noexcept;

/// Notes how far a study has come, for the message if the program ends before the study could be written.
/// @param total   evaluations of the study, 0 if unknown
/// @param budget  the total is a budget, which may not be used up
void note_study_progress(std::uint64_t done, std::uint64_t total, bool budget) noexcept;

/// Prints on standard error that a study was interrupted after so many evaluations, and how it is resumed.
void say_study_interrupted(std::uint64_t done);

/// Provides a stop token during its lifetime. A stop is requested soon after the program was asked to stop.
class StopOnInterrupt {
 public:
  StopOnInterrupt();
  std::stop_token token() const { return source_.get_token(); }

 private:
  std::stop_source source_;
  std::jthread watcher_;
};

}  // namespace twum::inline v0_1::cli
