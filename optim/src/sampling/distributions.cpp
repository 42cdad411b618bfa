// SPDX-License-Identifier: Apache-2.0
#include <twum/base/no_value.hpp>
#include <twum/optim/distributions.hpp>

#include <twum/base/error.hpp>

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <limits>
#include <numbers>

namespace twum::inline v0_1::optim {
namespace {

namespace policies = boost::math::policies;

// Makes Boost compute in double: long double differs from machine to machine, and valgrind has none. Boost's functions
// name both entries where they call one another, so each of them is compiled once only if both are named here.
// Arguments without a meaning give NaN, and overflow infinity, in place of Boost's exceptions.
using Quiet = policies::policy<policies::promote_float<false>, policies::promote_double<false>,
                               policies::domain_error<policies::ignore_error>,
                               policies::pole_error<policies::ignore_error>,
                               policies::overflow_error<policies::ignore_error>,
                               policies::evaluation_error<policies::ignore_error>>;
using StudentsT = boost::math::students_t_distribution<double, Quiet>;
using ChiSquare = boost::math::chi_squared_distribution<double, Quiet>;
using FisherF = boost::math::fisher_f_distribution<double, Quiet>;
using Binomial = boost::math::binomial_distribution<double, Quiet>;

// Beyond these ends Boost's functions lose their way, and a count does not differ from the next one.
constexpr double kLeastCount = 1e-3, kMostCount = 1e15;

bool is_probability(double p) { return p >= 0.0 && p <= 1.0; }
bool is_count(double n) { return n >= kLeastCount && n <= kMostCount; }

}  // namespace

double normal_density(double x) {
  return std::exp(-0.5 * x * x) * (0.5 * std::numbers::inv_sqrtpi * std::numbers::sqrt2);
}

double normal_cdf(double x) { return 0.5 * std::erfc(-x / std::numbers::sqrt2); }

double normal_quantile(double p) {
  if (std::isnan(p)) return kNoValue;
  if (p <= 0.0 || p >= 1.0) return std::copysign(std::numeric_limits<double>::infinity(), p - 0.5);
  return -std::numbers::sqrt2 * boost::math::erfc_inv(2.0 * p, Quiet());
}

// Plackett's identity: dPhi2/drho is the joint density, integrated here over rho = sin t from 0.
double normal_cdf(double h, double k, double rho) {
  const double product = normal_cdf(h) * normal_cdf(k);
  if (std::isnan(product) || std::isnan(rho)) return kNoValue;
  if (!std::isfinite(h) || !std::isfinite(k)) return product;
  const double sign = rho < 0.0 ? -1.0 : 1.0;
  const auto density = [&](double t) {
    const double cosine = std::cos(t);
    const double square = h * h + k * k - 2.0 * h * k * sign * std::sin(t);
    return std::exp(-0.5 * square / (cosine * cosine)) / (2.0 * std::numbers::pi);
  };
  const double end = std::asin(std::min(std::abs(rho), 1.0));
  if (end == 0.0) return product;
  using Rule = boost::math::quadrature::gauss_kronrod<double, 31>;
  return product + sign * Rule::integrate(density, 0.0, end, 10, 1e-13);
}

double student_quantile(double freedom, double p) {
  if (!(freedom >= kLeastCount) || !is_probability(p)) return kNoValue;
  if (p == 0.0 || p == 1.0) return normal_quantile(p);
  return freedom > kMostCount ? normal_quantile(p) : quantile(StudentsT(freedom), p);
}

double student_tails(double freedom, double t) {
  if (!(freedom >= kLeastCount) || !(t >= 0.0)) return kNoValue;
  if (std::isinf(t)) return 0.0;
  return 2.0 * (freedom > kMostCount ? normal_cdf(-t) : cdf(complement(StudentsT(freedom), t)));
}

double chi_square_quantile(double freedom, double p) {
  if (!is_count(freedom) || !is_probability(p)) return kNoValue;
  return quantile(ChiSquare(freedom), p);
}

double chi_square_tail(double freedom, double x) {
  if (!(freedom == 0.0 || is_count(freedom)) || !(x >= 0.0)) return kNoValue;
  if (std::isinf(x)) return 0.0;
  return freedom == 0.0 ? 1.0 : cdf(complement(ChiSquare(freedom), x));
}

double fisher_quantile(double above, double below, double p) {
  if (!is_count(above) || !is_count(below) || !is_probability(p)) return kNoValue;
  if (p == 1.0) return std::numeric_limits<double>::infinity();
  try {
    return quantile(FisherF(above, below), p);
  } catch (const boost::math::evaluation_error&) {  // its iteration asks no policy; p about 1e-300
    return kNoValue;
  }
}

double binomial_cdf(double draws, double p, double count) {
  if (!(draws >= 0.0 && draws <= kMostCount) || !is_probability(p) || std::isnan(count))
    return kNoValue;
  if (count < 0.0) return 0.0;
  return count >= draws ? 1.0 : cdf(Binomial(draws, p), count);
}

// Boost rounds a real solution, so the last steps are ours.
double binomial_quantile(double draws, double p, double level) {
  if (!(draws >= 0.0 && draws <= kMostCount) || !is_probability(p) || !is_probability(level))
    return kNoValue;
  const Binomial hits(draws, p);
  double k = std::floor(quantile(hits, level));
  while (k > 0.0 && cdf(hits, k - 1.0) >= level) --k;
  while (k < draws && cdf(hits, k) < level) ++k;
  return k;
}

ProbabilityRange probability_range(std::uint64_t hits, std::uint64_t draws, double tail) {
  TWUM_ASSERT(hits <= draws && draws > 0);
  const auto k = static_cast<double>(hits), n = static_cast<double>(draws);
  return {Binomial::find_lower_bound_on_p(n, k, tail), Binomial::find_upper_bound_on_p(n, k, tail)};
}

}  // namespace twum::inline v0_1::optim
