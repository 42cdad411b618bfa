// SPDX-License-Identifier: Apache-2.0
#include <twum/optim/yield_estimate.hpp>

#include "double_precision.hpp"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <twum/base/error.hpp>

namespace twum::optim {
namespace {

using Binomial = boost::math::binomial_distribution<double, DoublePrecision>;

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
  TWUM_ASSERT(good <= products && products > 0);
  const auto k = static_cast<double>(good);
  const auto n = static_cast<double>(products);
  return {good, products, k / n, Binomial::find_lower_bound_on_p(n, k, kTail),
          Binomial::find_upper_bound_on_p(n, k, kTail)};
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

}  // namespace twum::optim
