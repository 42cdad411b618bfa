// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/estimate.hpp>

#include <cstdint>

namespace twum::inline v0_1::optim {

/// Mean and standard deviation of independent draws in one pass (Pebay 2008), accurate even if the mean is much
/// larger than the spread. The order of the draws changes the result by rounding only.
class Moments {
 public:
  /// Adds a draw, a finite number.
  void add(double value) noexcept;

  /// Draws so far.
  std::uint64_t count() const noexcept { return count_; }
  /// Mean; NaN without draws.
  double mean() const noexcept;
  /// Standard deviation with n - 1; NaN for fewer than 2 draws.
  double sd() const noexcept;

  /// Student's interval. Exact for normal draws, and by the central limit theorem accurate for many others.
  /// @param confidence  between 0 and 1
  IntervalEstimate mean_estimate(double confidence) const;
  /// Bonett's interval (2006), which uses the kurtosis. A chi-squared interval is wrong for draws that are not
  /// normal, however many there are.
  IntervalEstimate sd_estimate(double confidence) const;

 private:
  std::uint64_t count_{0};
  double mean_{0};
  double second_{0};  // sums of powers of the deviations from the mean
  double third_{0};
  double fourth_{0};
};

}  // namespace twum::inline v0_1::optim
