// SPDX-License-Identifier: Apache-2.0
#include <twum/core/contact/normal_contact.hpp>

#include "contact/load_shape.hpp"

#include <cmath>
#include <numbers>

namespace twum {
namespace {

constexpr double kPi = std::numbers::pi;

double load_shape(double t) {
  if (t > contact::kLoadSeriesReach) return std::sin(t) - t * std::cos(t);
  return contact::load_shape_series(t);
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
