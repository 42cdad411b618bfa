// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/estimate.hpp>
#include <twum/optim/robust_problem.hpp>
#include <twum/optim/yield_estimate.hpp>

#include <vector>

namespace twum::inline v0_1::optim {

/// A statistic of the values of independent products, with its 95 % interval; those without an answer do not count.
IntervalEstimate statistic_estimate(const StatisticTarget& target, std::vector<double> values);

/// Whether the limits of a statistic hold at both ends of its interval, U5.7; holds for one without limits.
YieldVerdict verdict_on(const StatisticTarget& target, const IntervalEstimate& seen);

/// What is added to a statistic of the search, so that the next independent sample is likely to confirm its limit, U5.8.
/// @param searched  its value in the search, without what was added
double statistic_shift(const StatisticTarget& target, const IntervalEstimate& seen,
                       double searched);

}  // namespace twum::inline v0_1::optim
