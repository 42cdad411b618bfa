// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/zone_integrals.hpp"

#include <algorithm>
#include <array>

namespace twum::inline v0_1::contact {

/// Own and forced part of the layer's motion cancel in small contacts, which costs the closed forms
/// eps (1 + response) / (s theta_L^3) of the powers: more than 1e-13 is too much.
template <typename S>
bool is_delicate(const ContactNumbers<S>& n, const LayerMotion<S>& layer) {
  const double size = std::min<double>(value_of(n.half_angle), 1.0);
  return layer.kind() != LayerKind::elastic &&
         1 + value_of(layer.response) > 600 * value_of(n.stick_rate) * size * size * size;
}

/// A slip zone that is short against the layer's own times, by Taylor series (E5.3) from its start.
///
/// There the layer's own and its forced motion nearly cancel, and their difference would have few
/// digits. The series of e itself has them all: with z = rate * length its terms fall like z^k / k!, and
/// those of products like (2 z)^k / k!. Only a fast mode of an overdamped layer that falls below exp(-2.5)
/// within the zone stays apart, in closed form beside the series.
template <typename S>
class ShortSlip {
 public:
  /// Largest rate times length that the series is made for.
  static constexpr double kReach = 2.5;

  /// Rate that the series has to resolve, at least that of the wave [1 / rad].
  static double rate(const LayerMotion<S>& layer) {
    const double M = value_of(layer.M), C = value_of(layer.C);
    if (layer.kind() != LayerKind::oscillating)
      return std::fmax(1, std::fabs(value_of(layer.slow())));
    return std::fmax(1, std::fmax(C / M, layer.natural_frequency()));
  }

  ShortSlip(const ContactNumbers<S>& n, const LayerMotion<S>& layer, double sigma,
            const Phase<S>& from, const S& length, const LayerState<S>& start, const S& fast)
      : n_(n),
        layer_(layer),
        q_(-(sigma * n.kinetic)),
        length_(length),
        has_mode_apart_(nearly_ends_within(layer, length)),
        fast_(has_mode_apart_ ? fast : S(0.0)),
        terms_(count(2 * rate_of_series() * value_of(length))) {
    expand_pressure(from);
    layer.kind() == LayerKind::relaxing || has_mode_apart_ ? expand_decay(start, from)
                                                           : expand_motion(start);
  }

  /// Integrals of p e' and C e'^2.
  SlipWork<S> work(const Phase<S>& from, const Phase<S>& to) const {
    // Coefficients of the products, all of them at once: no sum has to wait for itself.
    S a[kTerms], b[kTerms];
    for (int k = 0; k < terms_; ++k) {
      a[k] = pressure_[0] * rate_[k];
      b[k] = rate_[0] * rate_[k];
    }
    for (int i = 1; i < terms_; ++i) {
      for (int k = i; k < terms_; ++k) {
        a[k] += pressure_[i] * rate_[k - i];
        b[k] += rate_[i] * rate_[k - i];
      }
    }
    SlipWork<S> w{S(0.0), S(0.0)};
    for (int k = terms_ - 1; k >= 0; --k) {
      w.rate_pressure += inverse(k + 1) * a[k];
      w.loss += inverse(k + 1) * b[k];
    }
    w = {w.rate_pressure * length_, layer_.C * (w.loss * length_)};
    if (has_mode_apart_) add_fast_mode(w, from, to);
    return w;
  }

  /// State of the layer at the zone's end.
  LayerState<S> end() const {
    const LayerState<S> e = series_at_end(), h = fast_at(length_);
    return {e.e + h.e, e.rate + h.rate};
  }

 private:
  static constexpr int kTerms = 44;
  static constexpr std::array<double, kTerms + 1> kInverse = [] {
    std::array<double, kTerms + 1> inverse{};
    for (int k = 1; k <= kTerms; ++k) inverse[static_cast<std::size_t>(k)] = 1.0 / k;
    return inverse;
  }();

  static double inverse(int k) { return kInverse[static_cast<std::size_t>(k)]; }

  static bool nearly_ends_within(const LayerMotion<S>& layer, const S& length) {
    return layer.kind() == LayerKind::overdamped &&
           -value_of(layer.fast()) * value_of(length) > kReach;
  }

  double rate_of_series() const {
    if (layer_.kind() != LayerKind::overdamped || has_mode_apart_) return rate(layer_);
    return std::fmax(1, -value_of(layer_.fast()));
  }

  // Where the layer enters at rest the products begin with terms that nearly cancel, of pressure and motion
  // alone: up to the fourth power, with inertia the sixth. Those of the layer's own times fall off behind them.
  static int count(double z) {
    constexpr int kFirst = 7;
    int terms = 2;
    for (double term = z * z / 2; term > 1e-17 && terms < kTerms - kFirst; term *= z / terms)
      ++terms;
    return terms + kFirst;
  }

  // p = w_L - (1 - cos theta), in powers of x / length.
  void expand_pressure(const Phase<S>& from) {
    const S wave[4] = {from.at.cos, -from.at.sin, -from.at.cos, from.at.sin};
    S power(1.0);
    pressure_[0] = n_.peak - from.at.versine;
    for (int k = 1; k < terms_; ++k) {
      power = power * (inverse(k) * length_);
      pressure_[k] = wave[k % 4] * power;
    }
  }

  // M e'' = t - C e' - e
  void expand_motion(const LayerState<S>& start) {
    S strain = start.e;
    strain_ = start.e;
    rate_[0] = start.rate;
    const S scale = length_ / layer_.M;
    for (int k = 0; k + 1 < terms_; ++k) {
      rate_[k + 1] = (q_ * pressure_[k] - layer_.C * rate_[k] - strain) * (inverse(k + 1) * scale);
      strain = rate_[k] * (inverse(k + 1) * length_);
    }
  }

  // e' = slow e + r: without inertia r = t / C; else, the fast mode apart, r is what its rate makes of t,
  // M (r' - fast r) = t.
  void expand_decay(const LayerState<S>& start, const Phase<S>& from) {
    S strain = start.e - fast_;
    strain_ = strain;
    if (layer_.kind() == LayerKind::relaxing) {
      for (int k = 0; k < terms_; ++k) step(k, S(q_ * pressure_[k] / layer_.C), strain);
      return;
    }
    const S lag = -1.0 / layer_.fast(), g = q_ / (-(layer_.M * layer_.fast()) * (1.0 + lag * lag));
    const S drive[4] = {
        g * (from.at.cos + lag * from.at.sin), g * (lag * from.at.cos - from.at.sin),
        -(g * (from.at.cos + lag * from.at.sin)), g * (from.at.sin - lag * from.at.cos)};
    step(0, S(g * (n_.peak - from.at.versine + lag * from.at.sin - lag * lag * (1.0 - n_.peak))),
         strain);
    S power(1.0);
    for (int k = 1; k < terms_; ++k) {
      power = power * (inverse(k) * length_);
      step(k, S(drive[k % 4] * power), strain);
    }
  }

  void step(int k, const S& drive, S& strain) {
    rate_[k] = layer_.slow() * strain + drive;
    strain = rate_[k] * (inverse(k + 1) * length_);
  }

  LayerState<S> series_at_end() const {
    S e(0.0), rate(0.0);
    for (int k = terms_ - 1; k >= 0; --k) {
      e += inverse(k + 1) * rate_[k];
      rate += rate_[k];
    }
    return {strain_ + e * length_, rate};
  }

  LayerState<S> fast_at(const S& x) const {
    using std::exp;
    if (!has_mode_apart_) return {S(0.0), S(0.0)};
    const S h = fast_ * exp(layer_.fast() * x);
    return {h, layer_.fast() * h};
  }

  // With e = series + h and M h'' + C h' + h = 0:
  // 2 C int e' h' = int t h' - [M e' h' + e h] for the series' e.
  void add_fast_mode(SlipWork<S>& w, const Phase<S>& from, const Phase<S>& to) const {
    const LayerState<S> h0{fast_, layer_.fast() * fast_}, h1 = fast_at(length_),
                                                          e1 = series_at_end();
    const RateMoments<S> own(layer_, from, to, h0, h1);
    const S p_own = own.c - (1.0 - n_.peak) * (h1.e - h0.e);
    const S cross =
        layer_.M * (e1.rate * h1.rate - rate_[0] * h0.rate) + e1.e * h1.e - strain_ * h0.e;
    w.rate_pressure += p_own;
    w.loss += 0.5 * (layer_.energy(h0) - layer_.energy(h1)) + q_ * p_own - cross;
  }

  const ContactNumbers<S>& n_;
  const LayerMotion<S>& layer_;
  S q_, length_;
  bool has_mode_apart_;
  S fast_, strain_;
  int terms_;
  S pressure_[kTerms], rate_[kTerms];  // of p and e', in powers of x / length
};

}  // namespace twum::inline v0_1::contact
