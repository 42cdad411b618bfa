// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/motor_model.hpp"

#include <algorithm>

namespace twum::inline v0_1::core {

/// A slice with its numbers in another scalar.
template <typename T, typename S, typename F>
Slice<T> mapped(const Slice<S>& s, F c) {
  const NormalContact<S>& n = s.contact;
  return {c(s.radius),
          c(s.width),
          c(s.shape),
          c(s.amplitude),
          c(s.crest_velocity),
          c(s.load),
          c(s.share),
          {c(n.half_angle), c(n.edge_cosine), c(n.pressure_amplitude), c(n.half_length),
           c(n.load_ratio), c(n.ratio), c(n.max_pressure), n.full},
          c(s.stick_gain),
          c(s.peak),
          {c(s.edge.sin), c(s.edge.cos), c(s.edge.versine)},
          c(s.pressure_force),
          c(s.torque_scale),
          c(s.power_scale),
          c(s.force_scale),
          c(s.radial)};
}

/// A model or a motor with its numbers in another scalar.
/// @param c  the number in that scalar
/// @{
template <typename T, typename S, typename F>
MotorModel<T> mapped(const MotorModel<S>& m, F c) {
  MotorModel<T> r{c(m.n),       c(m.r),          c(m.b),       c(m.kappa),          c(m.tilt),
                  c(m.youngs),  c(m.thickness),  c(m.shear),   c(m.viscosity),      c(m.inertia),
                  c(m.kinetic), c(m.threshold),  c(m.preload), c(m.stator_damping), {},
                  c(m.slope),   c(m.compliance), m.track};
  std::transform(m.shape_numbers.begin(), m.shape_numbers.end(), r.shape_numbers.begin(), c);
  return r;
}
template <typename T, typename S, typename F>
DrivenMotor<T> mapped(const DrivenMotor<S>& m, F c) {
  DrivenMotor<T> r;
  static_cast<MotorModel<T>&>(r) = mapped<T>(static_cast<const MotorModel<S>&>(m), c);
  r.mean = mapped<T>(m.mean, c);
  r.omega = c(m.omega), r.lever = c(m.lever), r.holding_lever = c(m.holding_lever);
  r.indentation = c(m.indentation);
  for (const Piece<S>& p : m.pieces)
    r.pieces.push_back({c(p.low), c(p.high), p.root_low, p.root_high});
  for (const Slice<S>& s : m.annulus) r.annulus.push_back(mapped<T>(s, c));
  return r;
}
/// @}

}  // namespace twum::inline v0_1::core
