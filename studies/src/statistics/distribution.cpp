// SPDX-License-Identifier: Apache-2.0
#include <twum/base/error.hpp>
#include <twum/optim/distributions.hpp>
#include <twum/studies/distribution.hpp>

#include <boost/math/distributions/beta.hpp>
#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace twum::inline v0_1::studies {

namespace {

// Boost computes in double: long double differs from machine to machine, and valgrind has none.
using Beta = boost::math::beta_distribution<
    double, boost::math::policies::policy<boost::math::policies::promote_float<false>,
                                          boost::math::policies::promote_double<false>>>;

// Squared standard deviation over squared mean of a Weibull distribution; falls with its exponent.
double weibull_ratio(double exponent) {
  return std::expm1(std::lgamma(1 + 2 / exponent) - 2 * std::lgamma(1 + 1 / exponent));
}

double weibull_exponent(double ratio) {
  const double wanted = std::log(ratio * ratio);
  std::uintmax_t steps = 200;
  const auto found = boost::math::tools::toms748_solve(
      [&](double e) { return std::log(weibull_ratio(std::exp(e))) - wanted; }, std::log(0.1),
      std::log(1e4), boost::math::tools::eps_tolerance<double>(50), steps);
  return std::exp(0.5 * (found.first + found.second));
}

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

Distribution Distribution::weibull(double mean, double sd) {
  TWUM_ASSERT(mean > 0);
  const double exponent = weibull_exponent(sd / mean);
  return {Shape::weibull, mean / std::exp(std::lgamma(1 + 1 / exponent)), exponent};
}

Distribution Distribution::beta(double mean, double sd, double min, double max) {
  // Of the share (x - min) / (max - min): mean m, variance v; the exponents are m n and (1 - m) n, n + 1 = m (1 - m) / v.
  const double m = (mean - min) / (max - min), s = sd / (max - min);
  const double n = m * (1 - m) / (s * s) - 1;
  TWUM_ASSERT(n > 0);
  return {Shape::beta, min, max, m * n, (1 - m) * n};
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

// Of the shares below and above, the smaller one is the exact one.
Distribution::OfNormal Distribution::of_normal(double z) const {
  constexpr double kMost = 8.2;
  z = std::clamp(z, -kMost, kMost);
  if (!limited_) return whole_of_normal(z);
  const double part = top_ - bottom_;
  const double below = bottom_ + optim::normal_cdf(z) * part;
  const double over = above(max_) + optim::normal_cdf(-z) * part;
  const double at = below < over ? optim::normal_quantile(below) : -optim::normal_quantile(over);
  const auto [value, slope] = whole_of_normal(at);
  const double by_z = part * optim::normal_density(z) / optim::normal_density(at);
  return {std::clamp(value, min_, max_), slope * by_z};
}

Distribution::OfNormal Distribution::whole_of_normal(double z) const {
  const double below = optim::normal_cdf(z), over = optim::normal_cdf(-z);
  const double density = optim::normal_density(z), range = b_ - a_;
  switch (shape_) {
    case Shape::normal: return {a_ + b_ * z, b_};
    case Shape::lognormal: {
      const double value = std::exp(a_ + b_ * z);
      return {value, b_ * value};
    }
    case Shape::uniform: return {z < 0 ? a_ + range * below : b_ - range * over, range * density};
    case Shape::triangular: {
      const bool lower = below * range <= c_ - a_;
      const double root = std::sqrt(lower ? below * range * (c_ - a_) : over * range * (b_ - c_));
      const double side = lower ? c_ - a_ : b_ - c_;
      return {lower ? a_ + root : b_ - root, root > 0 ? 0.5 * range * side * density / root : 0};
    }
    case Shape::weibull: {
      const double log = z > 0 ? -std::log(over) : -std::log1p(-below);
      const double value = a_ * std::pow(log, 1 / b_);
      return {value, value / (b_ * log) * density / over};
    }
    case Shape::beta: {
      const Beta law(c_, d_);
      const double share = z < 0 ? boost::math::quantile(law, below)
                                 : boost::math::quantile(boost::math::complement(law, over));
      return {a_ + range * share, range * density / boost::math::pdf(law, share)};
    }
  }
  TWUM_ASSERT(false);
  return {};
}

// The share above x of the distribution before it is truncated.
double Distribution::above(double x) const {
  if (shape_ == Shape::normal) return optim::normal_cdf((a_ - x) / b_);
  return 1 - whole_cdf(x);
}

// By the midpoint rule in z, which is exact to rounding for smooth laws.
double Distribution::sd() const {
  constexpr double kStep = 0.05, kEnd = 8.2;
  double weight = 0, first = 0, second = 0;
  const double centre = of_normal(0).value;
  for (double z = -kEnd + 0.5 * kStep; z < kEnd; z += kStep) {
    const double density = optim::normal_density(z), off = of_normal(z).value - centre;
    weight += density;
    first += density * off;
    second += density * off * off;
  }
  return std::sqrt(second / weight - first * first / (weight * weight));
}

double Distribution::cdf(double x) const {
  if (!limited_) return whole_cdf(x);
  return (whole_cdf(std::clamp(x, min_, max_)) - bottom_) / (top_ - bottom_);
}

double Distribution::whole_cdf(double x) const {
  switch (shape_) {
    case Shape::normal: return optim::normal_cdf((x - a_) / b_);
    case Shape::lognormal: return x > 0 ? optim::normal_cdf((std::log(x) - a_) / b_) : 0;
    case Shape::uniform: return std::clamp((x - a_) / (b_ - a_), 0.0, 1.0);
    case Shape::triangular:
      if (x <= a_ || x >= b_) return x <= a_ ? 0 : 1;
      if (x <= c_) return (x - a_) / (b_ - a_) * ((x - a_) / (c_ - a_));
      return 1 - (b_ - x) / (b_ - a_) * ((b_ - x) / (b_ - c_));
    case Shape::weibull: return x > 0 ? -std::expm1(-std::pow(x / a_, b_)) : 0;
    case Shape::beta:
      return boost::math::cdf(Beta(c_, d_), std::clamp((x - a_) / (b_ - a_), 0.0, 1.0));
  }
  TWUM_ASSERT(false);
  return 0;
}

double Distribution::whole_quantile(double p) const {
  switch (shape_) {
    case Shape::normal: return a_ + b_ * optim::normal_quantile(p);
    case Shape::lognormal: return std::exp(a_ + b_ * optim::normal_quantile(p));
    case Shape::uniform: return a_ + p * (b_ - a_);
    case Shape::triangular:
      if (p * (b_ - a_) <= c_ - a_) return a_ + std::sqrt(p * (b_ - a_) * (c_ - a_));
      return b_ - std::sqrt((1 - p) * (b_ - a_) * (b_ - c_));
    case Shape::weibull: return a_ * std::pow(-std::log1p(-p), 1 / b_);
    case Shape::beta: return a_ + (b_ - a_) * boost::math::quantile(Beta(c_, d_), p);
  }
  TWUM_ASSERT(false);
  return 0;
}

}  // namespace twum::inline v0_1::studies
