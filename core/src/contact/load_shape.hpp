// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/contact_numbers.hpp"

#include <cmath>
#include <numbers>

namespace twum::inline v0_1::contact {

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
  return twum::detail::chain(versine, angle, T(1.0 / sin(angle)));
}

/// The contact under a crest that presses with p(0) = w P (W2.2). Its edge takes no sine of theta_L.
template <typename S>
struct CrestContact {
  S angle;  ///< theta_L: 0 where the crest does not touch, pi in full contact
  S load;   ///< in the units of load_shape(); its derivative in w is theta_L (W2.4)
  Trig<S> edge;
};

namespace detail {

inline double crest_load(double /*peak*/, double angle, const Trig<double>& edge) {
  return load_shape(angle, edge);
}
template <typename T, int N>
Dual<T, N> crest_load(const Dual<T, N>& peak, const Dual<T, N>& angle,
                      const Trig<Dual<T, N>>& edge) {
  const Trig<T> inner{edge.sin.v, edge.cos.v, edge.versine.v};
  return twum::detail::chain(peak, crest_load(peak.v, angle.v, inner), angle.v);
}

}  // namespace detail

template <typename S>
CrestContact<S> crest_contact(const S& peak) {
  using std::sqrt;
  constexpr double kPi = std::numbers::pi;
  if (!(value_of(peak) > 0)) return {S(0.0), S(0.0), {S(0.0), S(1.0), S(0.0)}};
  if (!(value_of(peak) < 2)) return {S(kPi), S(kPi * (peak - 1.0)), {S(0.0), S(-1.0), S(2.0)}};
  const Trig<S> edge{sqrt(S(peak * (2.0 - peak))), S(1.0 - peak), peak};
  const S angle = angle_of_versine(peak);
  return {angle, detail::crest_load(peak, angle, edge), edge};
}

}  // namespace twum::inline v0_1::contact
