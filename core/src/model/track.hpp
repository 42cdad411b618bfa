// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/motor_model.hpp"

#include <type_traits>

namespace twum::inline v0_1::core {

/// R - 1 of a mode (P8.1).
/// @param place  from the mean radius, in half widths of the track
template <typename S, typename R>
R mode_excess(const MotorModel<S>& m, const R& place) {
  R sum(m.shape_numbers.back());
  for (std::size_t i = kShapeNumbers - 1; i-- > 0;) sum = sum * place + R(m.shape_numbers[i]);
  return sum * place;
}

/// R(rho) - 1 (W1.3), accurate where the shape is nearly 1; R is S or carries more derivatives than S.
template <typename S, typename R>
R shape_excess(const MotorModel<S>& m, const R& radius) {
  if (m.track.mode) return mode_excess(m, R(2.0 * (radius - m.r) / m.b));
  if (m.track.table) return m.track.table->at(radius) / m.track.table->at(m.r) - 1.0;
  using std::expm1, std::log1p;
  const auto& [exponent, root, unused, none] = m.shape_numbers;
  if constexpr (std::is_same_v<S, double>)
    if (exponent == 0) return R(0.0);
  const R along = (radius - m.r) / (m.r - root);
  return expm1(R(exponent * log1p(along)));
}

/// R' / R at a radius.
template <typename S>
S shape_slope(const MotorModel<S>& m, const S& radius) {
  if (m.track.table) return m.track.table->slope(radius) / m.track.table->at(radius);
  if (!m.track.mode) return m.shape_numbers[0] / (radius - m.shape_numbers[1]);
  const S per_radius = 2.0 / m.b, place = per_radius * (radius - m.r);
  S slope(0.0);
  for (std::size_t i = kShapeNumbers; i-- > 0;)
    slope = slope * place + static_cast<double>(i + 1) * m.shape_numbers[i];
  return per_radius * slope / (1.0 + mode_excess(m, place));
}

/// |q| at the contact radius (R1.1).
template <typename S>
S ratio_at_contact(const MotorModel<S>& m) {
  if constexpr (!contact::kHasRadialMotion) return S(0.0);
  const S q = m.r / m.n * shape_slope(m, m.r);
  return value_of(q) < 0 ? S(-q) : q;
}

/// How much deeper the crest stands in the layer at a radius than at the mean radius (W2.1, V3.1) [m].
template <typename S, typename R>
R crest_rise(const DrivenMotor<S>& m, const R& radius) {
#ifdef __wasm__  // see worn_track()
  return m.mean.amplitude * shape_excess(m, radius) - (radius - m.r) * m.slope;
#else
  const R rise = m.mean.amplitude * shape_excess(m, radius) - (radius - m.r) * m.slope;
  return worn_track(m) ? R(rise - worn_beyond_mean(m, radius)) : rise;
#endif
}

/// The contact at a radius of the track (W1.2, W2.2), half_angle 0 where the wave does not reach the rotor. For one slice it
/// is that at the mean radius.
template <typename S>
Slice<S> slice_at(const DrivenMotor<S>& m, const S& radius, const S& width);

/// Those edges of an annulus that touch: no part of a sum, but the first slices to stick.
template <typename S>
Vector<Slice<S>> edges_of(const DrivenMotor<S>& m);

/// Largest pressure p(0) over the track (W5.1) [Pa].
template <typename S>
S largest_pressure(const DrivenMotor<S>& m);

/// Largest pressure over the track, averaged over a wave, in parts of that of the whole track (W5.2) [1].
template <typename S>
S pressure_nonuniformity(const DrivenMotor<S>& m);

}  // namespace twum::inline v0_1::core
