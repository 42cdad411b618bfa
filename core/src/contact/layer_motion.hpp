// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/contact_numbers.hpp"
#include "contact/scalars.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>

namespace twum::inline v0_1::contact {

/// State of the layer: strain e and its derivative in theta. Without inertia only e counts.
template <typename S>
struct LayerState {
  S e, rate;
};

/// cos(x) and sin(x) / x as Taylor polynomials in q = x^2, which may be negative. What is left out is below
/// q^6 / 12!.
/// @{
template <typename S>
S cosine_series(const S& q) {
  return 1.0 -
         q * (1.0 / 2) *
             (1.0 - q * (1.0 / 12) *
                        (1.0 - q * (1.0 / 30) * (1.0 - q * (1.0 / 56) * (1.0 - q * (1.0 / 90)))));
}
template <typename S>
S sine_series(const S& q) {
  return 1.0 -
         q * (1.0 / 6) *
             (1.0 - q * (1.0 / 20) *
                        (1.0 - q * (1.0 / 42) * (1.0 - q * (1.0 / 72) * (1.0 - q * (1.0 / 110)))));
}
/// @}

/// Homogeneous motion h(x) of the layer, M h'' + C h' + h = 0, x = theta since the zone began.
///
/// Oscillating layers: u = h(0), w = h'(0). Otherwise amplitudes of the modes: u of the fast one,
/// w of the slow one (the only one of a relaxing layer).
template <typename S>
struct FreeMotion {
  S u, w;
};

/// The layer's equation of motion, M e'' + C e' + e = t, solved for every kind of layer.
template <typename S>
class LayerMotion {
 public:
  LayerMotion(const S& inertia, const S& damping) : M(inertia), C(damping), D(1.0 - inertia) {
    using std::sqrt;
    response = 1.0 / (D * D + C * C);
    if (value_of(M) == 0) {
      kind_ = value_of(C) == 0 ? LayerKind::elastic : LayerKind::relaxing;
      if (kind_ == LayerKind::relaxing) slow_ = -1.0 / C;
      return;
    }
    const S inverse = 1.0 / M, half_rate = 0.5 * C * inverse;
    const S square = inverse - half_rate * half_rate;  // beta^2, negative past critical damping
    inverse_inertia_ = value_of(inverse);
    if (value_of(C) * value_of(C) < 9.0 * value_of(M)) {
      kind_ = LayerKind::oscillating;
      decay_ = half_rate;
      square_ = square;
      // At critical damping beta = 0 has no derivative, and the series below does not need it.
      if (std::fabs(value_of(square)) > 1e-12) {
        beta_ = sqrt(value_of(square) > 0 ? square : S(-square));
        inverse_beta_ = 1.0 / beta_;
      }
      return;
    }
    kind_ = LayerKind::overdamped;
    fast_ = -half_rate - sqrt(-square);
    slow_ = 1.0 / (M * fast_);
    inverse_gap_ = 1.0 / (slow_ - fast_);
  }

  /// The same motion in double.
  decltype(auto) values() const {
    if constexpr (std::is_same_v<S, double>) {
      return (*this);
    } else {
      return LayerMotion<double>(value_of(M), value_of(C));
    }
  }

  LayerKind kind() const { return kind_; }
  /// True for the two forms with inertia that need no series where they meet, if no angle of the vibration within a turn is more
  /// than the sine of lanes takes, 1e5 (a layer with a natural frequency of 16 000 times the wave's is as good as rigid).
  bool serves_lanes() const {
    const double square = value_of(square_), most = 1e5 / (2 * std::numbers::pi);
    return kind_ == LayerKind::overdamped ||
           (kind_ == LayerKind::oscillating && square > 1e-3 && square < most * most);
  }
  bool has_inertia() const {
    return kind_ == LayerKind::oscillating || kind_ == LayerKind::overdamped;
  }

  /// A difference of states as far as the layer can hold it: an elastic layer has no state of its own,
  /// and without inertia the rate follows from e.
  LayerState<S> own_part(const LayerState<S>& h) const {
    switch (kind_) {
      case LayerKind::elastic: return {S(0.0), S(0.0)};
      case LayerKind::relaxing: return {h.e, slow_ * h.e};
      default: return h;
    }
  }

  /// The homogeneous motion that starts from h = e, h' = rate.
  template <typename R = S>
  FreeMotion<R> start(const LayerState<R>& h) const {
    switch (kind_) {
      case LayerKind::oscillating: return {h.e, h.rate};
      case LayerKind::overdamped:
        return {(slow_ * h.e - h.rate) * inverse_gap_, (h.rate - fast_ * h.e) * inverse_gap_};
      case LayerKind::relaxing: return {R(0.0), h.e};
      default: return {R(0.0), R(0.0)};
    }
  }

  /// h and h' after x >= 0; R is S, or Lanes in a layer that serves_lanes().
  template <typename R = S>
  LayerState<R> at(const FreeMotion<R>& motion, const R& x) const {
    using std::exp;
    switch (kind_) {
      case LayerKind::oscillating: {
        const Propagator<R> p = propagator(x);
        const R glide = motion.w + decay_ * motion.u;
        const R h = p.cosine * motion.u + p.sine * glide;
        return {h, p.cosine * glide - square_ * (p.sine * motion.u) - decay_ * h};
      }
      case LayerKind::overdamped: {
        const R fast = motion.u * exp(fast_ * x), slow = motion.w * exp(slow_ * x);
        return {fast + slow, fast_ * fast + slow_ * slow};
      }
      case LayerKind::relaxing: {
        const R slow = motion.w * exp(slow_ * x);
        return {slow, slow_ * slow};
      }
      default: return {R(0.0), R(0.0)};
    }
  }

  /// Energy M h'^2 + h^2 of a homogeneous state; it falls by 2 C h'^2.
  template <typename R = S>
  R energy(const LayerState<R>& h) const {
    return M * h.rate * h.rate + h.e * h.e;
  }

  /// Of a quantity that oscillates as the layer does: how far below zero it goes from here on (E4.9). It is lowest here or in
  /// its next trough; later troughs are less deep. Infinite if the layer does not oscillate.
  /// @param value, slope  of the quantity here; the slope is in theta
  template <typename R = S>
  R depth(const R& value, const R& slope) const {
    using std::exp, std::max, std::sqrt;
    const double beta = value_of(beta_), decay = value_of(decay_);
    if (!(value_of(square_) > 0 && beta > 0)) return HUGE_VAL;
    const R sine = (slope + decay * value) * value_of(inverse_beta_);
    const R phase = least_argument(R(beta * value + decay * sine), slope);
    const R swing = beta * sqrt(R(value_of(M) * (value * value + sine * sine)));
    const R trough = swing * exp(R(-decay * value_of(inverse_beta_) * (std::numbers::pi + phase)));
    return max(R(-value), trough);
  }

  /// Decay over a turn of the oscillation, which leaves exp(-decay_in_a_turn()) of the swing. 0 if the layer does not
  /// oscillate.
  double decay_in_a_turn() const {
    return 2 * std::numbers::pi * value_of(decay_) * value_of(inverse_beta_);
  }

  /// Rates of decay: the real part of the slower mode [1 / rad], for deciding what can be neglected.
  double slowest_decay() const {
    if (kind_ == LayerKind::elastic) return HUGE_VAL;
    if (kind_ != LayerKind::oscillating) return -value_of(slow_);
    const double square = value_of(square_);
    return value_of(decay_) - (square < 0 ? std::sqrt(-square) : 0.0);
  }

  /// 1 / sqrt(M), of an undamped layer, in units of W.
  double natural_frequency() const { return std::sqrt(inverse_inertia_); }
  /// 1 / M
  double inverse_inertia() const { return inverse_inertia_; }
  const S& fast() const { return fast_; }
  const S& slow() const { return slow_; }

  S M, C, D;   ///< of the equation of motion; D = 1 - M
  S response;  ///< 1 / (D^2 + C^2), response of the layer to the wave's own frequency

 private:
  // exp(-zeta x) cos(beta x) and exp(-zeta x) sin(beta x) / beta, continued through beta^2 <= 0.
  template <typename R>
  struct Propagator {
    R cosine, sine;
  };

  template <typename R>
  Propagator<R> vibration(const R& x) const {
    using std::exp, twum::sincos;
    const R envelope = exp(-(decay_ * x));
    const SinCos<R> at = sincos(R(beta_ * x));
    return {envelope * at.cos, envelope * at.sin * inverse_beta_};
  }

  template <typename R>
  Propagator<R> propagator(const R& x) const {
    if constexpr (std::is_same_v<R, S>) {
      return anywhere(x);
    } else {
      return vibration(x);
    }
  }

  Propagator<S> anywhere(const S& x) const {
    using std::exp;
    const double turn = value_of(square_) * value_of(x) * value_of(x);
    if (std::fabs(turn) < 0.02) return series(x, exp(-(decay_ * x)));
    if (turn > 0) return vibration(x);
    const S up = exp((beta_ - decay_) * x), down = exp(-((beta_ + decay_) * x));
    return {0.5 * (up + down), 0.5 * (up - down) * inverse_beta_};
  }

  // In beta^2 x^2, below 0.02: what the series leave out is below 1e-19.
  Propagator<S> series(const S& x, const S& envelope) const {
    const S q = square_ * x * x;
    return {envelope * cosine_series(q), envelope * x * sine_series(q)};
  }

  LayerKind kind_{LayerKind::elastic};
  double inverse_inertia_{0};
  S decay_{0.0}, square_{0.0}, beta_{0.0}, inverse_beta_{0.0};  // oscillating: zeta, beta^2, |beta|
  S fast_{0.0}, slow_{0.0}, inverse_gap_{0.0};  // overdamped and relaxing: rates of the modes
};

}  // namespace twum::inline v0_1::contact
