// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

namespace twum::studies {

/// A number known from samples, with a confidence interval; NaN where there is none.
struct Estimate {
  double value{std::numeric_limits<double>::quiet_NaN()};
  double low{std::numeric_limits<double>::quiet_NaN()};
  double high{std::numeric_limits<double>::quiet_NaN()};
};

}  // namespace twum::studies
