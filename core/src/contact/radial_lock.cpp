// SPDX-License-Identifier: Apache-2.0
#include "contact/radial_lock.hpp"

#include <cmath>
#include <numbers>

namespace twum::inline v0_1::contact {
namespace {

constexpr int kSamples = 64;
constexpr int kHalvings = 60;

// The phase whose bound is the highest for a c_y, and how that bound goes with c_y.
struct Top {
  double theta, slope;
};

Top top_of(const LockBound<double>& bound, double across) {
  const double step = 2 * std::numbers::pi / kSamples;
  double best = 0, most = -HUGE_VAL;
  for (int i = 0; i < kSamples; ++i) {
    const auto value = bound(i * step, across);
    if (!value.reaches) return {i * step, std::copysign(HUGE_VAL, value.at)};
    if (value.at > most) most = value.at, best = i * step;
  }
  double low = best - step, high = best + step;  // its slope in theta falls through zero there
  for (int i = 0; i < kHalvings && high - low > 1e-15; ++i) {
    const double middle = 0.5 * (low + high);
    const auto value = bound(middle, across);
    if (!value.reaches) return {middle, std::copysign(HUGE_VAL, value.at)};
    (value.in_theta > 0 ? low : high) = middle;
  }
  best = 0.5 * (low + high);
  return {best, bound(best, across).in_across};
}

}  // namespace

TouchingPhases touching_phases(const ContactNumbers<double>& n, double side) {
  const LockBound<double> bound{n, side};
  double low = -n.threshold * n.peak, high = -low;
  Top below{0, -HUGE_VAL}, above{0, HUGE_VAL};
  for (int i = 0; i < kHalvings && high - low > 1e-16 * n.peak; ++i) {
    const double middle = 0.5 * (low + high);
    const Top top = top_of(bound, middle);
    (top.slope < 0 ? low : high) = middle;
    (top.slope < 0 ? below : above) = top;
  }
  const bool exist = std::isfinite(below.slope) && std::isfinite(above.slope);
  return {exist,
          0.5 * (low + high),
          {below.theta, above.theta},
          above.slope / (above.slope - below.slope)};
}

}  // namespace twum::inline v0_1::contact
