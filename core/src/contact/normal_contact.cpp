// SPDX-License-Identifier: Apache-2.0
#include <twum/core/contact/normal_contact.hpp>

#include <twum/base/dual.hpp>

#include <cmath>
#include <numbers>

namespace twum {
namespace {

constexpr double kPi = std::numbers::pi;

// sin t - t cos t. Both terms tend to t, so small angles use the series: at the switch its first
// dropped term is 5e-16 of the sum, and the closed form loses 3 eps / t^2 = 1.4e-15 by rounding.
double load_shape(double t) {
  if (t > 0.7) return std::sin(t) - t * std::cos(t);
  const double q = t * t;
  const double tail = 1.0 / 518918400 - q / 93405312000;
  const double series =
      1.0 / 3 -
      q * (1.0 / 30 - q * (1.0 / 840 - q * (1.0 / 45360 - q * (1.0 / 3991680 - q * tail))));
  return t * q * series;
}

}  // namespace

// Newton's method from the right side of the root: the left-hand side is t^3 / 3 (1 - t^2 / 10 + ...)
// below pi / 2 and falls short of pi by (pi - t)^2 pi / 2 near pi. A bracket guards every step.
double contact_half_angle(double load) {
  if (!(load > 0)) return 0;
  double low = 0, high = kPi;
  double t = load < 2.0 ? std::cbrt(3 * load) : kPi - std::sqrt(2 * (kPi - load) / kPi);
  for (int i = 0; i < 60; ++i) {
    const double excess = load_shape(t) - load;
    if (excess == 0) break;
    (excess > 0 ? high : low) = t;
    double next = t - excess / (t * std::sin(t));
    if (!(next >= low && next <= high)) next = 0.5 * (low + high);
    const double step = std::fabs(next - t);
    t = next;
    if (step <= 4e-16 * t) break;
  }
  return t;
}

}  // namespace twum
