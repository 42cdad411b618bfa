// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/first_zero.hpp"
#include "contact/layer_motion.hpp"

#include <algorithm>
#include <cmath>

namespace twum::contact {

/// k0 + kb theta + kw (1 - cos theta) + ks sin theta: all that is not the layer's own motion.
template <typename S>
struct Harmonic {
  S k0, kb, kw, ks;

  S at(const S& theta, const Trig<S>& a) const {
    return k0 + kb * theta + kw * a.versine + ks * a.sin;
  }
  S slope(const Trig<S>& a) const { return kb + kw * a.sin + ks * a.cos; }
  S curvature(const Trig<S>& a) const { return kw * a.cos - ks * a.sin; }
  Harmonic<double> values() const {
    return {value_of(k0), value_of(kb), value_of(kw), value_of(ks)};
  }
};

/// Response e of a layer that slips with v_rel of sign sigma to t = -sigma mu p (T5.1, E2.1): its mean, written so
/// that it is as small as the pressure where the layer is stiff, and its swing.
template <typename S>
Harmonic<S> forced_response(const ContactNumbers<S>& n, const LayerMotion<S>& layer, double sigma) {
  const S q = -sigma * n.kinetic;
  const S excess = (layer.D * layer.M - layer.C * layer.C) * layer.response;  // D / (D^2 + C^2) - 1
  return {q * (excess + n.peak), S(0.0), -(q * layer.response * layer.D),
          q * layer.response * layer.C};
}

/// f' - s (cos theta - V): v_rel s / V0 without the layer's own motion (E2.2).
template <typename S>
Harmonic<S> relative_rate(const ContactNumbers<S>& n, const Harmonic<S>& f) {
  return {f.ks - n.stick_rate * (1.0 - n.speed_ratio), S(0.0), n.stick_rate - f.ks, f.kw};
}

/// For finding events: there 1 - cos theta may be rounded.
inline Trig<double> quick_trig(double theta) {
  const SinCos<double> a = twum::sincos(theta);
  return {a.sin, a.cos, 1 - a.cos};
}

/// Distance to the end of sticking on one side, f = mu_0 p - iota t (E2.4), along a stick zone; its bounds
/// are (E4.5).
class StickCurve {
 public:
  StickCurve(const Harmonic<double>& f, double theta, const Trig<double>& at)
      : f_(f), theta_(theta), at_(at), bound_(std::sqrt(f.kw * f.kw + f.ks * f.ks)) {}

  CurveSample first() const { return sample(theta_, at_); }
  CurveSample sample(double x) const { return sample(theta_ + x, quick_trig(theta_ + x)); }
  CurveSample terms(double x) const { return sample(x); }

  /// What both ends of a stretch tell of the zeros between them, mostly enough: f'' is a sinusoid.
  enum class Glance : unsigned char { no_zero, one_zero, unknown };

  /// @param order  what is known at the start
  /// @param end    phase after `length`
  Glance glance(double length, StartOrder order, const Trig<double>& end) const {
    const CurveSample a = first(), b = sample(theta_ + length, end);
    const bool leaves =
        order == StartOrder::positive ? a.f > 0 : order == StartOrder::zero && a.f1 > 0;
    if (!(length < kHalfTurn && leaves)) return Glance::unknown;
    // above zero as long as it is convex, if it starts so
    const bool starts_well = a.f2 < 0 || a.f1 >= 0 || a.f + a.f1 * length > 0;
    if (b.f < 0) return starts_well ? Glance::one_zero : Glance::unknown;  // (E4.7)
    if (!(b.f > 0)) return Glance::unknown;
    const bool ends_well = b.f2 < 0 || b.f1 <= 0 || b.f - b.f1 * length > 0;
    const bool convex = a.f2 >= 0 && b.f2 >= 0;
    const bool positive = convex ? stays_above(a, b) : starts_well && ends_well;  // (E4.8)
    return positive ? Glance::no_zero : Glance::unknown;
  }

  /// The zero on (0, length) after glance() has reported one zero.
  /// @param near  a place close to it, or kNoZero
  double only_zero(double length, double near) const {
    const double guess = near > 0 && near < length ? near : taylor_zero(first(), length);
    return polish_zero(*this, 0, length, guess, sample(guess));
  }

 private:
  CurveSample sample(double theta, const Trig<double>& a) const {
    const double slope = f_.slope(a);
    return {f_.at(theta, a), slope, f_.curvature(a), bound_, bound_, 0, f_.kb - slope};
  }

  // A little less than pi, over which a sinusoid changes its sign once.
  static constexpr double kHalfTurn = 3.14;

  // Convex and above zero at both ends: a parabola with the least curvature between lies below f.
  static bool stays_above(const CurveSample& a, const CurveSample& b) {
    return a.f1 >= 0 || b.f1 <= 0 || a.f1 * a.f1 < 2 * a.f * std::min(a.f2, b.f2);
  }

  // Zero within the length with sine and cosine as their Taylor polynomials, or the middle. A convex start
  // says little of it: then from the end.
  static double taylor_zero(const CurveSample& a, double length) {
    double t = length;
    if (a.f2 < 0) t = std::min((a.f1 + std::sqrt(a.f1 * a.f1 - 2 * a.f2 * a.f)) / -a.f2, length);
    for (int i = 0; i < 2; ++i) t += householder_step(taylor_sample(a, t));
    return t > 0 && t < length ? t : 0.5 * length;
  }

  // f'' is a sinusoid.
  static CurveSample taylor_sample(const CurveSample& a, double t) {
    const double cosine = cosine_series(t * t), sine = t * sine_series(t * t);
    const double versine = 1 - cosine, lag = t - sine;
    return {a.f + a.f1 * t + a.f2 * versine + a.f3 * lag,
            a.f1 + a.f2 * sine + a.f3 * versine,
            a.f2 * cosine + a.f3 * sine,
            0,
            0,
            0,
            a.f3 * cosine - a.f2 * sine};
  }

  Harmonic<double> f_;
  double theta_;
  Trig<double> at_;
  double bound_;
};

/// sigma v_rel along a slip zone, f = sigma (h' + harmonic): positive as long as the zone lasts.
///
/// The bounds (E4.1) come from the layer's own motion, which can only lose: the energy of an oscillating
/// layer's every derivative falls (E4.2, E4.3), and so do both modes of an overdamped one (E4.4).
class SlipCurve {
 public:
  /// @param theta, at    phase where the zone starts
  /// @param length, end  how long it may last, and the phase there
  SlipCurve(const LayerMotion<double>& layer, const FreeMotion<double>& motion,
            const Harmonic<double>& slow, double sigma, double theta, const Trig<double>& at,
            double length, const Trig<double>& end)
      : layer_(layer),
        motion_(motion),
        slow_{sigma * slow.k0, 0, sigma * slow.kw, sigma * slow.ks},
        sigma_(sigma),
        theta_(theta),
        at_(at),
        length_(length),
        swing_(std::sqrt(slow.kw * slow.kw + slow.ks * slow.ks)),
        least_share_(std::fmax(0.1, 1 - layer.decay_in_a_turn())),
        last_(slow_.at(0, end)),
        last_slope_(slow_.slope(end)) {}

  CurveSample first() const { return sample(0, at_, own_start()); }
  CurveSample sample(double x) const { return sample(x, quick_trig(theta_ + x), own_motion(x)); }

  /// Value and derivatives alone.
  CurveSample terms(double x) const {
    const Trig<double> a = quick_trig(theta_ + x);
    const Own own = own_motion(x);
    const double slope = slow_.slope(a);
    return {slow_.at(0, a) + sigma_ * own.rate,
            slope + sigma_ * own.rate1,
            slow_.curvature(a) + sigma_ * own.rate2,
            0,
            0,
            0,
            sigma_ * own.rate3 - slope};
  }

 private:
  // h' and its three derivatives, and bounds of -sigma h', |h'''|, |h''''| from x on.
  struct Own {
    double rate, rate1, rate2, rate3, bound0, bound2, bound3;
  };

  CurveSample sample(double x, const Trig<double>& a, const Own& own) const {
    const double slow = slow_.at(0, a), slope = slow_.slope(a);
    return {slow + sigma_ * own.rate,
            slope + sigma_ * own.rate1,
            slow_.curvature(a) + sigma_ * own.rate2,
            swing_ + own.bound2,
            swing_ + own.bound3,
            slow > least_share_ * own.bound0 ? skip(length_ - x, slow, slope, own) : 0,
            sigma_ * own.rate3 - slope};
  }

  Own own_motion(double x) const {
    switch (layer_.kind()) {
      case LayerKind::oscillating: return oscillation(layer_.at(motion_, x));
      case LayerKind::elastic: return {0, 0, 0, 0, 0, 0, 0};
      default: break;
    }
    const double fast = motion_.u == 0 ? 0 : motion_.u * std::exp(layer_.fast() * x);
    return modes(fast, motion_.w * std::exp(layer_.slow() * x));
  }

  Own own_start() const {
    switch (layer_.kind()) {
      case LayerKind::oscillating: return oscillation({motion_.u, motion_.w});
      case LayerKind::elastic: return {0, 0, 0, 0, 0, 0, 0};
      default: return modes(motion_.u, motion_.w);
    }
  }

  Own oscillation(const LayerState<double>& h) const {
    const double M = layer_.M, C = layer_.C, inverse = layer_.inverse_inertia();
    const double h2 = -(C * h.rate + h.e) * inverse, h3 = -(C * h2 + h.rate) * inverse,
                 h4 = -(C * h3 + h2) * inverse, h5 = -(C * h4 + h3) * inverse;
    return {h.rate,
            h2,
            h3,
            h4,
            std::sqrt(h.rate * h.rate + M * h2 * h2),
            std::sqrt(h3 * h3 + M * h4 * h4),
            std::sqrt(h4 * h4 + M * h5 * h5)};
  }

  Own modes(double u, double w) const {
    const double l1 = layer_.fast(), l2 = layer_.slow();
    const double fast = u * l1, slow = w * l2, fast2 = fast * l1 * l1, slow2 = slow * l2 * l2;
    return {fast + slow,
            fast * l1 + slow * l2,
            fast2 + slow2,
            fast2 * l1 + slow2 * l2,
            std::fmax(-sigma_ * fast, 0) + std::fmax(-sigma_ * slow, 0),
            std::fabs(fast2) + std::fabs(slow2),
            std::fabs(fast2 * l1) + std::fabs(slow2 * l2)};
  }

  // (E4.6) How far the harmonic part mean + rho cos(u) stays above what the layer's own motion takes from it: all the
  // `rest` of the zone if its lowest value there does.
  double skip(double rest, double slow, double slope, const Own& own) const {
    const double mean = slow_.k0 + slow_.kw;
    const bool may_turn = rest > 3 || (slope < 0 && last_slope_ > 0);
    const double lowest = may_turn ? mean - swing_ : std::fmin(slow, last_);
    if (lowest > own.bound0 || lowest > depth(own, lowest)) return kNoZero;
    if (!(slow > own.bound0)) return 0;
    return std::acos((own.bound0 - mean) / swing_) - std::atan2(-slope, slow - mean);
  }

  // (E4.9) How far sigma h' goes below zero, where it may be less than `enough`. It is seldom asked for, and makes the
  // march longer if it is inline.
  [[gnu::noinline]] double depth(const Own& own, double enough) const {
    const bool may_be = enough > least_share_ * own.bound0 && -sigma_ * own.rate < 0.5 * enough;
    return may_be ? layer_.depth(sigma_ * own.rate, sigma_ * own.rate1) : kNoZero;
  }

  const LayerMotion<double>& layer_;
  FreeMotion<double> motion_;
  Harmonic<double> slow_;
  double sigma_, theta_;
  Trig<double> at_;
  double length_;
  double swing_;              // rho
  double least_share_;        // of the bound of h'; below it no trough is looked for
  double last_, last_slope_;  // the harmonic part at the end of the length
};

}  // namespace twum::contact
