// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/dual.hpp>

namespace twum::contact {

/// All that the tangential contact depends on, dimensionless. Tractions are in units of the pressure
/// amplitude P = E A / h, velocities in units of the crest velocity V0, and e = G eps / P stands for
/// the layer's strain. Theory section 4 then reads, with ' = d / d theta,
///
///     M e'' + C e' + e = t,        v_rel / V0 = e' / s + V - cos theta,
///     p = cos theta - c            on |theta| <= theta_L.
///
/// Seven numbers; every motor parameter and the speed act through them.
template <typename S>
struct ContactNumbers {
  S inertia;       ///< M = m W^2 / G, square of wave frequency over the layer's own
  S damping;       ///< C = gamma W / G
  S stick_rate;    ///< s = G V0 / (h W P), traction gained in stick per radian and unit of speed ratio
  S speed_ratio;   ///< V = U / V0
  S half_angle;    ///< theta_L; pi in full contact
  S edge_cosine;   ///< c = cos theta_L in partial contact, <= -1 in full contact
  S kinetic;       ///< mu
  S static_;       ///< mu_0
  SinCos<S> edge;  ///< sine and cosine of theta_L
  bool full;       ///< full contact: no free zone, theta runs from -pi to pi
};

/// How the layer moves when left alone.
enum class LayerKind : unsigned char {
  elastic,      ///< M = C = 0: no motion of its own
  relaxing,     ///< M = 0 < C: one exponential
  oscillating,  ///< damping ratio below 1.5: real arithmetic with sine and cosine, or their analytic
                ///< continuation past critical damping
  overdamped    ///< two exponentials of well separated rates
};

/// Mean values over one turn of the wave, dimensionless, and the state of the layer at the next entry.
template <typename S>
struct ContactMeans {
  S traction;        ///< <t>; torque is 2 pi r^2 b P <t>
  S stator_power;    ///< <t cos theta>; powers are in units of 2 pi r b P V0
  S friction_power;  ///< <-t v_rel / V0> and the work of snaps
  S layer_loss;      ///< <C e'^2> / s
  S stick_length;    ///< length of the stick zones [rad]
};

}  // namespace twum::contact
