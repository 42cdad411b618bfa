// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

namespace twum::inline v0_1::optim {

/// An estimate from samples with its confidence interval; NaN where there is none.
struct IntervalEstimate {
  double value{std::numeric_limits<double>::quiet_NaN()};  ///< the estimate itself
  double low{std::numeric_limits<double>::quiet_NaN()};    ///< lower end of the interval
  double high{std::numeric_limits<double>::quiet_NaN()};   ///< upper end
};

}  // namespace twum::inline v0_1::optim
