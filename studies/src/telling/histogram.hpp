// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace twum::inline v0_1::studies::telling {

/// The interval in which values have to lie [SI]; an infinite end is open.
struct Window {
  double lower;
  double upper;

  bool holds(double value) const { return value >= lower && value <= upper; }
};

/// Equal bins over values.
struct Bins {
  double first;  ///< left end of the first
  double width;
  std::vector<std::size_t> kept;    ///< values inside the window, of each bin
  std::vector<std::size_t> failed;  ///< those outside

  double edge(std::size_t i) const { return first + static_cast<double>(i) * width; }
};

/// Counts finite values. The ends of the window are edges of bins, so that no bar is on both sides, unless the window is so
/// narrow that this would take more bins than can be seen.
/// @param values  at least two that differ
Bins counted_bins(const std::vector<double>& values, const Window& window);

}  // namespace twum::inline v0_1::studies::telling
