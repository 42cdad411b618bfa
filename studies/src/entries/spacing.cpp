// SPDX-License-Identifier: Apache-2.0
#include "entries/spacing.hpp"

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::studies {

double between(double min, double max, double t, optim::Scale scale) {
  if (t <= 0) return min;
  if (t >= 1) return max;
  const double value =
      scale == optim::Scale::log ? min * std::pow(max / min, t) : min + t * (max - min);
  return std::clamp(value, min, max);
}

}  // namespace twum::inline v0_1::studies
