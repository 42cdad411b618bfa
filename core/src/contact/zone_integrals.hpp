// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/layer_motion.hpp"
#include "contact/load_shape.hpp"
#include "contact/zone_curves.hpp"

#include <limits>

namespace twum::inline v0_1::contact {

/// Integrals of 1, cos, sin and their products over a zone.
template <typename S>
struct Moments {
  S one, c, s, cc, sc, ss;

  Moments(const Phase<S>& from, const Phase<S>& to) {
    one = to.theta - from.theta;
    c = to.at.sin - from.at.sin;
    s = to.at.versine - from.at.versine;
    sc = 0.5 * (to.at.sin * to.at.sin - from.at.sin * from.at.sin);
    const S product = to.at.sin * to.at.cos - from.at.sin * from.at.cos;
    cc = 0.5 * (one + product);
    ss = 0.5 * (one - product);
  }
};

/// Integrals of h' cos and h' sin over a zone, from the layer's states at its ends: its equation times
/// exp(i theta), integrated by parts, leaves boundary terms only (E5.1). Holds for every kind of layer.
template <typename S>
struct RateMoments {
  S c, s;

  template <typename L>
  RateMoments(const LayerMotion<L>& layer, const Phase<S>& from, const Phase<S>& to,
              const LayerState<S>& h0, const LayerState<S>& h1) {
    const L& M = layer.M;
    const S b0 = M * h0.rate + layer.C * h0.e, b1 = M * h1.rate + layer.C * h1.e;
    const S m0 = M * h0.e, m1 = M * h1.e;
    const S re = b1 * to.at.cos + m1 * to.at.sin - (b0 * from.at.cos + m0 * from.at.sin);
    const S im = b1 * to.at.sin - m1 * to.at.cos - (b0 * from.at.sin - m0 * from.at.cos);
    c = h1.e * to.at.cos - h0.e * from.at.cos - layer.response * (re * layer.C + im * layer.D);
    s = h1.e * to.at.sin - h0.e * from.at.sin + layer.response * (re * layer.D - im * layer.C);
  }
};

/// The two integrals of a slip zone that need the layer's motion: of p e' and C e'^2. NaN where they are not asked for.
template <typename S>
struct SlipWork {
  S rate_pressure{std::numeric_limits<double>::quiet_NaN()};
  S loss{std::numeric_limits<double>::quiet_NaN()};
};

/// From the forced part f of e, and the layer's own part h0, h1 at the zone's ends; the own part loses
/// its energy (E5.2).
template <typename S, typename L>
SlipWork<S> slip_work(const ContactNumbers<S>& n, const LayerMotion<L>& layer, const Harmonic<S>& f,
                      const Moments<S>& m, const Phase<S>& from, const Phase<S>& to,
                      const LayerState<S>& h0, const LayerState<S>& h1) {
  const S c = 1.0 - n.peak;
  const S p0 = n.peak - from.at.versine, p1 = n.peak - to.at.versine;
  const S pc = m.cc - c * m.c, ps = 0.5 * (p0 * p0 - p1 * p1);
  const S p_forced = f.ks * pc + f.kw * ps;
  if (layer.kind() == LayerKind::elastic) return {p_forced, S(0.0)};
  const RateMoments<S> own(layer, from, to, h0, h1);
  const S p_own = own.c - c * (h1.e - h0.e);
  const S own_loss = 0.5 * (layer.energy(h0) - layer.energy(h1));
  const S cross_loss = 2.0 * (f.ks * own.c + f.kw * own.s);
  const S forced_loss = f.ks * f.ks * m.cc + 2.0 * (f.ks * f.kw) * m.sc + f.kw * f.kw * m.ss;
  return {p_own + p_forced, own_loss + layer.C * (cross_loss + forced_loss)};
}

/// Integrals over a slip zone.
template <typename S, typename Sign>
inline ContactMeans<S> slip_integrals(const ContactNumbers<S>& n, const Sign& sigma,
                                      const Moments<S>& m, const Phase<S>& from, const Phase<S>& to,
                                      const SlipWork<S>& work) {
  const S c = 1.0 - n.peak;
  const S p = n.peak * m.one - (m.one - m.c), pc = m.cc - c * m.c;
  const S ps = m.s * (n.peak - 0.5 * (from.at.versine + to.at.versine));
  const S q = sigma * n.kinetic;
  return {-(q * p),
          -(q * pc),
          q * (work.rate_pressure / n.stick_rate - pc + n.speed_ratio * p),
          work.loss / n.stick_rate,
          S(0.0),
          -(q * ps)};  // (D1.7)
}

/// Integrals over a stick zone with traction t = k0 + kb theta + kw (1 - cos theta) + ks sin theta.
template <typename S, typename L>
inline ContactMeans<S> stick_integrals(const ContactNumbers<S>& n, const LayerMotion<L>& layer,
                                       const Harmonic<S>& t, const Phase<S>& from,
                                       const Phase<S>& to) {
  const Moments<S> m(from, to);
  const S theta = 0.5 * (to.theta * to.theta - from.theta * from.theta);
  const S theta_c = to.theta * to.at.sin - from.theta * from.at.sin - m.s;
  const S g0 = load_shape(from.theta, from.at), g1 = load_shape(to.theta, to.at);
  const S versine_s = 0.5 * (to.at.versine * to.at.versine - from.at.versine * from.at.versine);
  const S ss = 0.5 * (to.theta * to.at.sin * to.at.sin - to.at.cos * g1 -
                      (from.theta * from.at.sin * from.at.sin - from.at.cos * g0));
  const S& V = n.speed_ratio;
  return {t.k0 * m.one + t.kb * theta + t.kw * (m.one - m.c) + t.ks * m.s,
          t.k0 * m.c + t.kb * theta_c + t.kw * (m.c - m.cc) + t.ks * m.sc,
          S(0.0),
          layer.C * n.stick_rate * (m.cc - 2.0 * V * m.c + V * V * m.one),
          m.one,
          t.k0 * m.s + t.kb * (g1 - g0) + t.kw * versine_s + t.ks * ss};  // (D1.8)
}

template <typename S>
void add(ContactMeans<S>& sum, const ContactMeans<S>& zone) {
  sum.traction += zone.traction;
  sum.stator_power += zone.stator_power;
  sum.friction_power += zone.friction_power;
  sum.layer_loss += zone.layer_loss;
  sum.stick_length += zone.stick_length;
  sum.reactive_force += zone.reactive_force;
}

}  // namespace twum::inline v0_1::contact
