// SPDX-License-Identifier: Apache-2.0
#include "robust/statistic_verdict.hpp"

#include <twum/optim/sample_moments.hpp>
#include <twum/optim/sample_quantiles.hpp>

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::optim {
namespace {

constexpr double kConfidence = 0.95;

// Half intervals of room: one for the interval of the next sample, one for the errors of both samples, which are sqrt(2) of a
// standard error of 1 / 1.96 of it; together 92 % of the next samples confirm the limit.
constexpr double kRoom = 2;

}  // namespace

IntervalEstimate statistic_estimate(const StatisticTarget& target, std::vector<double> values) {
  std::erase_if(values, [](double v) { return !std::isfinite(v); });
  if (target.kind == Statistic::quantile) {
    std::ranges::sort(values);
    return quantile_estimate(values, target.probability, kConfidence);
  }
  Moments moments;
  for (const double v : values) moments.add(v);
  return target.kind == Statistic::mean ? moments.mean_estimate(kConfidence)
                                        : moments.sd_estimate(kConfidence);
}

YieldVerdict verdict_on(const StatisticTarget& target, const IntervalEstimate& seen) {
  const bool low = target.lower > -kInfinity, high = target.upper < kInfinity;
  if ((low && seen.high < target.lower) || (high && seen.low > target.upper))
    return YieldVerdict::broken;
  const bool holds = (!low || seen.low >= target.lower) && (!high || seen.high <= target.upper);
  return holds ? YieldVerdict::holds : YieldVerdict::not_distinguishable;
}

double statistic_shift(const StatisticTarget& target, const IntervalEstimate& seen,
                       double searched) {
  const double error = seen.value - searched;
  const bool at_upper = target.upper < kInfinity && !(seen.high <= target.upper);
  const double room =
      at_upper ? kRoom * (seen.high - seen.value) : -kRoom * (seen.value - seen.low);
  return std::isfinite(room) ? error + room : error;
}

}  // namespace twum::inline v0_1::optim
