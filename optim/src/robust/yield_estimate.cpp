// SPDX-License-Identifier: Apache-2.0
#include <twum/optim/yield_estimate.hpp>

#include <algorithm>
#include <cmath>
#include <twum/optim/distributions.hpp>

namespace twum::inline v0_1::optim {
namespace {

constexpr double kTail = 0.025;  // outside the interval, on each side

}  // namespace

const char* to_string(YieldVerdict verdict) {
  switch (verdict) {
    case YieldVerdict::holds: return "holds";
    case YieldVerdict::not_distinguishable: return "not-distinguishable";
    case YieldVerdict::broken: return "broken";
  }
  return "unknown";
}

YieldEstimate yield_estimate(std::uint64_t good, std::uint64_t products) {
  const ProbabilityRange range = probability_range(good, products, kTail);
  return {good, products, static_cast<double>(good) / static_cast<double>(products), range.low,
          range.high};
}

YieldVerdict verdict_on(const YieldEstimate& estimate, double wanted) {
  if (estimate.low >= wanted) return YieldVerdict::holds;
  return estimate.high < wanted ? YieldVerdict::broken : YieldVerdict::not_distinguishable;
}

// The failure rate is then known to 10 % relative. More products cost time but improve the objective, because the
// search may aim at a larger risk (U5.4).
std::uint64_t products_for(double risk) {
  return static_cast<std::uint64_t>(std::round(std::clamp(400.0 / risk, 20000.0, 1e6)));
}

// p' + 3.24 sqrt(p' / N) = p, a quadratic equation for sqrt(p').
double risk_to_aim_at(double risk, std::uint64_t products) {
  const double half = 1.62 / std::sqrt(static_cast<double>(products));
  const double root = std::sqrt(half * half + risk) - half;
  return root * root;
}

// The interval of 16 samples of 4096 weighted products ends a few per cent above its middle: standard errors of one risk
// are 1 to 2 %. If that is not enough, the answer is solved again with less (U5.6).
double risk_to_aim_at_weighted(double risk) {
  constexpr double kRoom = 0.05;
  return risk / (1.0 + kRoom);
}

}  // namespace twum::inline v0_1::optim
