// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/dual.hpp>

namespace twum::inline v0_1::contact {

/// Sine, cosine and versine 1 - cos of a phase. Contacts may be small: pressures are differences of
/// versines, which keep full relative accuracy where cosines are all nearly one.
template <typename S>
struct Trig {
  S sin, cos, versine;
};

template <typename S>
Trig<S> trig_of(const SinCos<S>& a) {
  return {a.sin, a.cos, value_of(a.cos) > 0 ? S(a.sin * a.sin / (1.0 + a.cos)) : S(1.0 - a.cos)};
}

template <typename S>
Trig<S> trig(const S& theta) {
  return trig_of(twum::sincos(theta));
}

/// With derivatives, from what is known of the value.
template <typename T, int N>
Trig<Dual<T, N>> trig_near(const Dual<T, N>& theta, const Trig<T>& at) {
  using twum::detail::chain;
  return {chain(theta, at.sin, at.cos), chain(theta, at.cos, T(-at.sin)),
          chain(theta, at.versine, at.sin)};
}
template <typename T, int N>
Trig<Dual<T, N>> trig(const Dual<T, N>& theta) {
  return trig_near(theta, trig(theta.v));
}

/// A phase of the wave.
template <typename S>
struct Phase {
  S theta;
  Trig<S> at;
};

/// All that the tangential contact depends on, dimensionless. Tractions are in units of the pressure
/// amplitude P = E A / h, velocities in units of the crest velocity V0, and e = G eps / P stands for
/// the layer's strain. Theory section 4 then reads, with ' = d / d theta,
///
///     M e'' + C e' + e = t                                              (E1.2, T4.1)
///     v_rel / V0 = e' / s + V - cos theta                               (E1.3, T2.3, T2.4)
///     p = w_L - (1 - cos theta)    on |theta| <= theta_L.
///
/// Eight numbers; every motor parameter and the speed act through them. Where the surface moves radially, too, all but the
/// pressure are vectors (R2.1, R2.2).
template <typename S>
struct ContactNumbers {
  S inertia;     ///< M = m W^2 / G, square of wave frequency over the layer's own
  S damping;     ///< C = gamma W / G
  S stick_rate;  ///< s = G V0 / (h W P), traction gained in stick per radian and unit of speed ratio
  S speed_ratio;  ///< V = U / V0
  S half_angle;   ///< theta_L; pi in full contact
  S peak;         ///< w_L = p(0): 1 - cos theta_L in partial contact, >= 2 in full contact
  S kinetic;      ///< mu
  S threshold;    ///< mu_0
  Trig<S> edge;   ///< of theta_L
  bool full;      ///< full contact: no free zone, theta runs from -pi to pi
  S radial{0.0};  ///< q, radial motion of the surface per tangential one (R1.1)
};

/// The numbers without derivatives.
template <typename S>
ContactNumbers<double> values_of(const ContactNumbers<S>& n) {
  const auto at = [](const S& x) { return value_of(x); };
  return {at(n.inertia),
          at(n.damping),
          at(n.stick_rate),
          at(n.speed_ratio),
          at(n.half_angle),
          at(n.peak),
          at(n.kinetic),
          at(n.threshold),
          {at(n.edge.sin), at(n.edge.cos), at(n.edge.versine)},
          n.full,
          at(n.radial)};
}

/// How the layer moves when left alone.
enum class LayerKind : unsigned char {
  elastic,      ///< M = C = 0: no motion of its own
  relaxing,     ///< M = 0 < C: one exponential
  oscillating,  ///< damping ratio below 1.5: real arithmetic with sine and cosine, or their analytic
                ///< continuation past critical damping
  overdamped    ///< two exponentials of well separated rates
};

/// Mean values over one turn of the wave, dimensionless. What comes in goes out (T7.10).
template <typename S>
struct ContactMeans {
  S traction;        ///< <t>; torque is 2 pi r^2 b P <t>
  S stator_power;    ///< <t cos theta> (T7.2); powers are in units of 2 pi r b P V0
  S friction_power;  ///< <-t v_rel / V0> and the work of snaps (T7.3)
  S layer_loss;      ///< <C e'^2> / s (T7.4)
  S stick_length;    ///< length of the stick zones [rad]
  S reactive_force;  ///< <t sin theta> (D1.6); forces on the wave are in units of 2 pi r b P kappa a
};

}  // namespace twum::inline v0_1::contact
