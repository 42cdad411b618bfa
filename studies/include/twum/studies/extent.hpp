// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace twum::inline v0_1::studies {

/// The smallest and the largest of some values; infinite the wrong way round while there are none.
struct Extent {
  double low{std::numeric_limits<double>::infinity()};    ///< smallest
  double high{-std::numeric_limits<double>::infinity()};  ///< largest

  /// Takes a value in, unless it is not finite.
  void add(double value) {
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

}  // namespace twum::inline v0_1::studies
