// SPDX-License-Identifier: Apache-2.0
#include <twum/core/contact/normal_contact.hpp>

#include "contact/load_shape.hpp"

#include <cmath>
#include <numbers>

namespace twum {
namespace {

constexpr double kPi = std::numbers::pi;
// of the angle, and of what it lacks of pi; what a step leaves is its third power
constexpr double kLastStep = 1e-6;
constexpr double kRounding = 5e-16;  // of the load

// The inverse of t^3 / 3 (1 - t^2 / 10 + t^4 / 280 - ...) below, of pi - (pi - t)^2 pi / 2 near pi.
double first_angle(double load) {
  if (!(load < 2.0)) return kPi - std::sqrt(2 * (kPi - load) / kPi);
  const double c = std::cbrt(3 * load), square = c * c;
  return c * (1 + square * (1.0 / 30 + square * (4.0 / 900 - 1.0 / 840)));
}

}  // namespace

// Halley's method for sin t - t cos t = load. A bracket guards every step.
double contact_half_angle(double load) {
  if (!(load > 0)) return 0;
  double low = 0, high = kPi, t = first_angle(load);
  for (int i = 0; i < 60; ++i) {
    const double s = std::sin(t), c = std::cos(t);
    const double shape = t > contact::kLoadSeriesReach ? s - t * c : contact::load_shape_series(t);
    const double excess = shape - load, slope = t * s;
    if (std::fabs(excess) <= kRounding * load) break;
    (excess > 0 ? high : low) = t;
    const double newton = excess / slope;
    double next = t - newton / (1 - 0.5 * newton * (s + t * c) / slope);
    if (!(next >= low && next <= high)) next = 0.5 * (low + high);
    const double step = std::fabs(next - t);
    t = next;
    if (step <= kLastStep * std::fmin(t, kPi - t)) break;
  }
  return t;
}

}  // namespace twum
