// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/contact_numbers.hpp"

#include <cmath>
#include <numbers>

namespace twum::contact {

/// Up to here load_shape_series() is as good as the closed form: its first dropped term is 5e-16 of the sum,
/// and the closed form loses 3 eps / t^2 = 1.4e-15 by rounding.
inline constexpr double kLoadSeriesReach = 0.7;

/// g(t) = sin t - t cos t for |t| <= kLoadSeriesReach, where both terms tend to t.
template <typename S>
S load_shape_series(const S& t) {
  const S q = t * t;
  const S tail = 1.0 / 518918400 - q / 93405312000;
  const S series =
      1.0 / 3 -
      q * (1.0 / 30 - q * (1.0 / 840 - q * (1.0 / 45360 - q * (1.0 / 3991680 - q * tail))));
  return t * q * series;
}

/// g(theta) = sin theta - theta cos theta with full relative accuracy: what a contact of this half angle carries (T3.2), and
/// the integral of theta sin theta (D1.8).
template <typename S>
S load_shape(const S& theta, const Trig<S>& at) {
  return std::fabs(value_of(theta)) > kLoadSeriesReach ? S(at.sin - theta * at.cos)
                                                       : load_shape_series(theta);
}

/// The angle of 0 .. pi whose versine 1 - cos is `versine`; S is double or carries derivatives, which are infinite at 0.
inline double angle_of_versine(double versine) { return 2 * std::asin(std::sqrt(0.5 * versine)); }
template <typename T, int N>
Dual<T, N> angle_of_versine(const Dual<T, N>& versine) {
  using std::sin;
  const T angle = angle_of_versine(versine.v);
  return detail::chain(versine, angle, T(1.0 / sin(angle)));
}

/// theta_L of a crest that presses with p(0) = w P (W2.2): 0 where it does not touch, pi in full contact.
template <typename S>
S contact_angle_of(const S& peak) {
  if (!(value_of(peak) > 0)) return S(0.0);
  if (!(value_of(peak) < 2)) return S(std::numbers::pi);
  return angle_of_versine(peak);
}

/// Load of such a contact in the units of load_shape(), and its derivative in w, which is theta_L (W2.4).
struct LoadAndAngle {
  double load, angle;
};
inline LoadAndAngle load_and_angle(double peak) {
  const double angle = contact_angle_of(peak);
  return {peak < 2 ? load_shape(angle, trig(angle)) : std::numbers::pi * (peak - 1), angle};
}
/// The load alone.
/// @{
inline double load_of_peak(double peak) { return load_and_angle(peak).load; }
template <typename T, int N>
Dual<T, N> load_of_peak(const Dual<T, N>& peak) {
  return detail::chain(peak, T(load_of_peak(peak.v)), contact_angle_of(peak.v));
}
/// @}

}  // namespace twum::contact
