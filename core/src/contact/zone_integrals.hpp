// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/layer_motion.hpp"
#include "contact/zone_curves.hpp"

namespace twum::contact {

template <typename S>
struct Phase {
  S theta;
  SinCos<S> at;
};

/// Integrals of 1, cos, sin and their products over a zone.
template <typename S>
struct Moments {
  S one, c, s, cc, sc, ss;

  Moments(const Phase<S>& from, const Phase<S>& to) {
    one = to.theta - from.theta;
    c = to.at.sin - from.at.sin;
    s = from.at.cos - to.at.cos;
    sc = 0.5 * (to.at.sin * to.at.sin - from.at.sin * from.at.sin);
    const S product = to.at.sin * to.at.cos - from.at.sin * from.at.cos;
    cc = 0.5 * (one + product);
    ss = 0.5 * (one - product);
  }
};

/// Integrals of h' cos and h' sin over a zone, from the layer's states at its ends: its equation times
/// exp(i theta), integrated by parts, leaves boundary terms only. Holds for every kind of layer.
template <typename S>
struct RateMoments {
  S c, s;

  RateMoments(const LayerMotion<S>& layer, const Phase<S>& from, const Phase<S>& to,
              const LayerState<S>& h0, const LayerState<S>& h1) {
    const S& M = layer.M;
    const S b0 = M * h0.rate + layer.C * h0.e, b1 = M * h1.rate + layer.C * h1.e;
    const S m0 = M * h0.e, m1 = M * h1.e;
    const S re = b1 * to.at.cos + m1 * to.at.sin - (b0 * from.at.cos + m0 * from.at.sin);
    const S im = b1 * to.at.sin - m1 * to.at.cos - (b0 * from.at.sin - m0 * from.at.cos);
    c = h1.e * to.at.cos - h0.e * from.at.cos - layer.response * (re * layer.C + im * layer.D);
    s = h1.e * to.at.sin - h0.e * from.at.sin + layer.response * (re * layer.D - im * layer.C);
  }
};

/// Integrals over a slip zone; f is the forced part of e, h0 and h1 the layer's own at the zone's ends.
template <typename S>
ContactMeans<S> slip_integrals(const ContactNumbers<S>& n, const LayerMotion<S>& layer, double sigma,
                               const Harmonic<S>& f, const Phase<S>& from, const Phase<S>& to,
                               const LayerState<S>& h0, const LayerState<S>& h1) {
  const Moments<S> m(from, to);
  const RateMoments<S> own(layer, from, to, h0, h1);
  const S& c = n.edge_cosine;
  const S p = m.c - c * m.one, pc = m.cc - c * m.c;
  const S p_forced_rate = f.ks * pc - f.kc * (m.sc - c * m.s);
  const S p_own_rate = own.c - c * (h1.e - h0.e);
  const S q = sigma * n.kinetic;
  const S own_loss = 0.5 * (layer.energy(h0) - layer.energy(h1));
  const S cross_loss = 2.0 * (f.ks * own.c - f.kc * own.s);
  const S forced_loss = f.ks * f.ks * m.cc - 2.0 * (f.ks * f.kc) * m.sc + f.kc * f.kc * m.ss;
  return {-(q * p), -(q * pc), q * ((p_own_rate + p_forced_rate) / n.stick_rate - pc + n.speed_ratio * p),
          (own_loss + layer.C * (cross_loss + forced_loss)) / n.stick_rate, S(0.0)};
}

/// Integrals over a stick zone with traction t = k0 + kb theta + kc cos theta + ks sin theta.
template <typename S>
ContactMeans<S> stick_integrals(const ContactNumbers<S>& n, const LayerMotion<S>& layer, const Harmonic<S>& t,
                                const Phase<S>& from, const Phase<S>& to) {
  const Moments<S> m(from, to);
  const S theta = 0.5 * (to.theta * to.theta - from.theta * from.theta);
  const S theta_c = to.theta * to.at.sin - from.theta * from.at.sin - m.s;
  const S& V = n.speed_ratio;
  return {t.k0 * m.one + t.kb * theta + t.kc * m.c + t.ks * m.s,
          t.k0 * m.c + t.kb * theta_c + t.kc * m.cc + t.ks * m.sc, S(0.0),
          layer.C * n.stick_rate * (m.cc - 2.0 * V * m.c + V * V * m.one), m.one};
}

template <typename S>
void add(ContactMeans<S>& sum, const ContactMeans<S>& zone) {
  sum.traction += zone.traction;
  sum.stator_power += zone.stator_power;
  sum.friction_power += zone.friction_power;
  sum.layer_loss += zone.layer_loss;
  sum.stick_length += zone.stick_length;
}

}  // namespace twum::contact
