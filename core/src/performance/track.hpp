// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "performance/motor_model.hpp"

namespace twum::performance {

/// R(rho) - 1 (W1.3), accurate where the shape is nearly 1; R is S or carries more derivatives than S.
template <typename S, typename R>
R shape_excess(const MotorModel<S>& m, const R& radius) {
  if (m.track.table) return m.track.table->at(radius) / m.track.table->at(m.r) - 1.0;
  using std::expm1, std::log1p;
  const R along = (radius - m.r) / (m.r - m.root);
  return expm1(R(m.exponent * log1p(along)));
}

/// How much deeper the crest stands in the layer at a radius than at the mean radius (W2.1) [m].
template <typename S, typename R>
R crest_rise(const DrivenMotor<S>& m, const R& radius) {
  return m.amplitude * shape_excess(m, radius) - (radius - m.r) * m.slope;
}

/// The contact at a radius of the track (W1.2, W2.2), half_angle 0 where the wave does not reach the rotor. For one slice it
/// is that at the mean radius.
template <typename S>
Slice<S> slice_at(const DrivenMotor<S>& m, const S& radius, const S& width);

/// Largest pressure p(0) over the track (W5.1) [Pa].
template <typename S>
S largest_pressure(const DrivenMotor<S>& m);

/// Largest pressure over the track, averaged over a wave, in parts of that of the whole track (W5.2) [1].
template <typename S>
S pressure_nonuniformity(const DrivenMotor<S>& m);

}  // namespace twum::performance
