// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/contact_numbers.hpp"

#include <cmath>

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

}  // namespace twum::contact
