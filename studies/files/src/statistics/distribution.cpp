// SPDX-License-Identifier: Apache-2.0
#include "statistics/double_precision.hpp"

#include <twum/base/error.hpp>
#include <twum/studies/statistics/distribution.hpp>

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/triangular.hpp>
#include <cmath>

namespace twum::studies {
namespace {

namespace math = boost::math;
using Normal = math::normal_distribution<double, DoublePrecision>;
using Triangular = math::triangular_distribution<double, DoublePrecision>;

}  // namespace

Distribution Distribution::normal(double mean, double sd) { return {Shape::normal, mean, sd}; }

Distribution Distribution::lognormal(double mean, double sd) {
  TWUM_ASSERT(mean > 0);
  // Mean exp(m + s^2 / 2) and variance (exp(s^2) - 1) mean^2 of the quantity, solved for m and s.
  const double ratio = sd / mean;
  const double variance = std::log1p(ratio * ratio);
  return {Shape::lognormal, std::log(mean) - variance / 2, std::sqrt(variance)};
}

Distribution Distribution::uniform(double min, double max) { return {Shape::uniform, min, max}; }

Distribution Distribution::triangular(double min, double mode, double max) {
  return {Shape::triangular, min, max, mode};
}

Distribution Distribution::within(double min, double max) const {
  Distribution result = *this;
  result.bottom_ = whole_cdf(min);
  result.top_ = whole_cdf(max);
  result.min_ = min;
  result.max_ = max;
  result.limited_ = true;
  return result;
}

double Distribution::quantile(double p) const {
  if (!limited_) return whole_quantile(p);
  const double share = bottom_ + p * (top_ - bottom_);
  // Keeps a probability that rounds to 0 or 1 inside the open interval.
  const double inside = std::clamp(share, 0x1.0p-1022, 1 - 0x1.0p-53);
  return std::clamp(whole_quantile(inside), min_, max_);
}

double Distribution::whole_cdf(double x) const {
  switch (shape_) {
    case Shape::normal: return std::isinf(x) ? (x > 0 ? 1.0 : 0.0) : math::cdf(Normal(a_, b_), x);
    case Shape::lognormal:
      if (!(x > 0)) return 0;
      return std::isinf(x) ? 1.0 : math::cdf(Normal(a_, b_), std::log(x));
    case Shape::uniform: return std::clamp((x - a_) / (b_ - a_), 0.0, 1.0);
    case Shape::triangular:
      if (x <= a_ || x >= b_) return x <= a_ ? 0 : 1;
      return math::cdf(Triangular(a_, c_, b_), x);
  }
  TWUM_ASSERT(false);
  return 0;
}

double Distribution::whole_quantile(double p) const {
  switch (shape_) {
    case Shape::normal: return math::quantile(Normal(a_, b_), p);
    case Shape::lognormal: return std::exp(math::quantile(Normal(a_, b_), p));
    case Shape::uniform: return a_ + p * (b_ - a_);
    case Shape::triangular: return math::quantile(Triangular(a_, c_, b_), p);
  }
  TWUM_ASSERT(false);
  return 0;
}

}  // namespace twum::studies
