// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace twum::inline v0_1::cli {

/// Progress of a command.
struct ProgressState {
  std::size_t done{0};  ///< evaluations, or rows
  double fraction{0};   ///< share of the whole that is done, 0 if unknown
  bool budget{false};   ///< the whole is a budget, which may not be used up
  std::string stage{};  ///< current stage
  std::string best{};   ///< the best so far
};

/// One line on the terminal: a bar with the share that is done, how many evaluations, their rate, the time left, the
/// stage, and the best so far; on a narrow terminal the less important parts are left out. Prints nothing if standard
/// error is not a terminal.
class Progress {
 public:
  Progress();
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(const ProgressState& now);

 private:
  using Clock = std::chrono::steady_clock;
  std::string line(const ProgressState& now, double seconds, std::size_t width) const;

  bool shown_{false};
  Clock::time_point begin_;
  Clock::time_point last_;
  std::size_t done_before_{0};  // evaluations of an earlier run
  double fraction_before_{0};
  double fraction_last_{0};
  bool counting_{false};
};

/// True if text on standard error may be coloured: a terminal, and NO_COLOR is not set.
bool may_colour_errors();

/// An estimate of seconds as "42 s", "3 min" or "5 h".
std::string duration_text(double seconds);

}  // namespace twum::inline v0_1::cli
