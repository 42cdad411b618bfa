// SPDX-License-Identifier: Apache-2.0
#include "robust/normal.hpp"

#include "double_precision.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <limits>
#include <numbers>

namespace twum::optim {

double normal_density(double x) {
  return std::exp(-0.5 * x * x) * (0.5 * std::numbers::inv_sqrtpi * std::numbers::sqrt2);
}

double normal_cdf(double x) { return 0.5 * std::erfc(-x / std::numbers::sqrt2); }

double normal_quantile(double p) {
  if (p <= 0.0 || p >= 1.0) return std::copysign(std::numeric_limits<double>::infinity(), p - 0.5);
  return -std::numbers::sqrt2 * boost::math::erfc_inv(2.0 * p, DoublePrecision());
}

// Plackett's identity: dPhi2/drho is the joint density, integrated here over rho = sin t from 0.
double normal_cdf(double h, double k, double rho) {
  const double product = normal_cdf(h) * normal_cdf(k);
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

}  // namespace twum::optim
