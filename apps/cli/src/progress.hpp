// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace twum::cli {

/// A line on the terminal with what is done, the rate, and the time left; nothing at all if standard
/// error is no terminal.
class Progress {
 public:
  Progress();
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// @param done      items so far, such as rows
  /// @param fraction  of the whole that is done, 0 if unknown
  /// @param best      what to say of the best so far
  void show(std::size_t done, double fraction, const std::string& best = {});

 private:
  using Clock = std::chrono::steady_clock;
  bool terminal_;
  bool shown_{false};
  Clock::time_point begin_;
  Clock::time_point last_;
  std::size_t done_before_{0};  // what an earlier run had done already
  double fraction_before_{0};
  bool counting_{false};
};

/// True if text on standard error may be coloured: a terminal, and NO_COLOR is not set.
bool may_colour_errors();

/// Seconds as "42 s" or "3 min 05 s".
std::string duration_text(double seconds);

}  // namespace twum::cli
