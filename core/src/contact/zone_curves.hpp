// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/first_zero.hpp"
#include "contact/layer_motion.hpp"

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::contact {

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
template <typename S, typename L, typename Sign>
Harmonic<S> forced_response(const ContactNumbers<S>& n, const LayerMotion<L>& layer,
                            const Sign& sigma) {
  const S q = -sigma * n.kinetic;
  const L excess = (layer.D * layer.M - layer.C * layer.C) * layer.response;  // D / (D^2 + C^2) - 1
  return {q * (excess + n.peak), S(0.0), -(q * layer.response * layer.D),
          q * layer.response * layer.C};
}

/// f' - s (cos theta - V): v_rel s / V0 without the layer's own motion (E2.2).
template <typename S>
Harmonic<S> relative_rate(const ContactNumbers<S>& n, const Harmonic<S>& f) {
  return {f.ks - n.stick_rate * (1.0 - n.speed_ratio), S(0.0), n.stick_rate - f.ks, f.kw};
}

/// Traction of a layer that sticks from a place with this strain e on: M e'' + C e' + e (T5.3, E2.3).
template <typename S, typename L>
Harmonic<S> sticking_traction(const ContactNumbers<S>& n, const LayerMotion<L>& layer,
                              const Phase<S>& from, const S& e) {
  const S& s = n.stick_rate;
  const S drift = s * n.speed_ratio;
  return {e - s * from.at.sin + drift * from.theta + layer.C * s * (1.0 - n.speed_ratio), -drift,
          -(layer.C * s), layer.D * s};
}

/// Its strain (T5.2).
template <typename S>
S sticking_strain(const ContactNumbers<S>& n, const Phase<S>& from, const S& e,
                  const Phase<S>& to) {
  const S& s = n.stick_rate;
  return e + s * (to.at.sin - from.at.sin) - s * n.speed_ratio * (to.theta - from.theta);
}

/// What a traction t leaves to the threshold on one side, mu_0 p - iota t (E2.4).
template <typename S, typename Sign>
Harmonic<S> reserve(const ContactNumbers<S>& n, const Harmonic<S>& t, const Sign& iota) {
  return {n.threshold * n.peak - iota * t.k0, -iota * t.kb, -n.threshold - iota * t.kw,
          -iota * t.ks};
}

/// For finding events: there 1 - cos theta may be rounded.
template <typename S>
Trig<S> quick_trig(const S& theta) {
  using twum::sincos;
  const SinCos<S> a = sincos(theta);
  return {a.sin, a.cos, 1.0 - a.cos};
}

/// Distance to the end of sticking on one side, the reserve f = mu_0 p - iota t (E2.4), along a stick zone; its bounds
/// are (E4.5). S is double or Lanes.
template <typename S>
class StickTerms {
 public:
  StickTerms(const Harmonic<S>& f, const S& theta, const Trig<S>& at)
      : f_(f), theta_(theta), at_(at), bound_(swing_of(f)) {}

  SampleOf<S> first() const { return sample(theta_, at_); }
  SampleOf<S> sample(const S& x) const { return sample(theta_ + x, quick_trig(S(theta_ + x))); }
  SampleOf<S> terms(const S& x) const { return sample(x); }
  /// @param end  phase after `length`
  SampleOf<S> last(const S& length, const Trig<S>& end) const {
    return sample(theta_ + length, end);
  }

  // A little less than pi, over which a sinusoid changes its sign once.
  static constexpr double kHalfTurn = 3.14;

  /// What the samples a and b at both ends of a stretch tell of the zeros between them, mostly enough: f'' is a sinusoid. Asked
  /// only over less than kHalfTurn, for an f that is positive at first.
  /// @{
  /// Above zero as long as it is convex, if it starts so.
  static auto starts_well(const SampleOf<S>& a, const S& length) {
    return a.f2 < 0.0 || a.f1 >= 0.0 || a.f + a.f1 * length > 0.0;
  }
  /// (E4.7), for b below zero.
  static auto has_one_zero(const SampleOf<S>& a, const S& length) { return starts_well(a, length); }
  /// (E4.8), for b above zero.
  static auto has_no_zero(const SampleOf<S>& a, const SampleOf<S>& b, const S& length) {
    const auto ends_well = b.f2 < 0.0 || b.f1 <= 0.0 || b.f - b.f1 * length > 0.0;
    const auto convex = a.f2 >= 0.0 && b.f2 >= 0.0;
    return (convex && stays_above(a, b)) || (!convex && starts_well(a, length) && ends_well);
  }
  /// @}

  /// The zero on (0, length) with sine and cosine as their Taylor polynomials, or the middle. A convex start says little of it:
  /// then from the end.
  S taylor_zero(const S& length) const {
    using std::min, std::sqrt;
    const SampleOf<S> a = first();
    const S top = (a.f1 + sqrt(S(a.f1 * a.f1 - 2.0 * a.f2 * a.f))) / -a.f2;
    S t = select(a.f2 < 0.0, min(top, length), length);
    for (int i = 0; i < 2; ++i) t += householder_step(taylor_sample(a, t));
    return select(t > 0.0 && t < length, t, 0.5 * length);
  }

 private:
  // f'' is a sinusoid.
  static SampleOf<S> taylor_sample(const SampleOf<S>& a, const S& t) {
    const S cosine = cosine_series(S(t * t)), sine = t * sine_series(S(t * t));
    const S versine = 1.0 - cosine, lag = t - sine, zero(0.0);
    return {a.f + a.f1 * t + a.f2 * versine + a.f3 * lag,
            a.f1 + a.f2 * sine + a.f3 * versine,
            a.f2 * cosine + a.f3 * sine,
            zero,
            zero,
            zero,
            a.f3 * cosine - a.f2 * sine};
  }

  static S swing_of(const Harmonic<S>& f) {
    using std::sqrt;
    return sqrt(S(f.kw * f.kw + f.ks * f.ks));
  }

  SampleOf<S> sample(const S& theta, const Trig<S>& a) const {
    const S slope = f_.slope(a);
    return {f_.at(theta, a), slope, f_.curvature(a), bound_, bound_, S(0.0), f_.kb - slope};
  }

  // Convex and above zero at both ends: a parabola with the least curvature between lies below f.
  static auto stays_above(const SampleOf<S>& a, const SampleOf<S>& b) {
    using std::min;
    return a.f1 >= 0.0 || b.f1 <= 0.0 || a.f1 * a.f1 < 2.0 * a.f * min(a.f2, b.f2);
  }

  Harmonic<S> f_;
  S theta_;
  Trig<S> at_;
  S bound_;
};

/// The same with a search for its zeros.
class StickCurve : public StickTerms<double> {
 public:
  using StickTerms::StickTerms;

  enum class Glance : unsigned char { no_zero, one_zero, unknown };

  /// What both ends of a stretch tell.
  /// @param order  what is known at the start
  /// @param end    phase after `length`
  Glance glance(double length, StartOrder order, const Trig<double>& end) const {
    const CurveSample a = first(), b = last(length, end);
    const bool leaves =
        order == StartOrder::positive ? a.f > 0 : order == StartOrder::zero && a.f1 > 0;
    if (!(length < kHalfTurn && leaves)) return Glance::unknown;
    if (b.f < 0) return has_one_zero(a, length) ? Glance::one_zero : Glance::unknown;
    return b.f > 0 && has_no_zero(a, b, length) ? Glance::no_zero : Glance::unknown;
  }

  /// The zero on (0, length) after glance() has reported one zero.
  /// @param near  a place close to it, or kNoZero
  double only_zero(double length, double near) const {
    const double guess = near > 0 && near < length ? near : taylor_zero(length);
    return polish_zero(*this, 0, length, guess, sample(guess));
  }
};

/// sigma v_rel along a slip zone, f = sigma (h' + harmonic): positive as long as the zone lasts. S is double or Lanes.
///
/// The bounds (E4.1) come from the layer's own motion, which can only lose: the energy of an oscillating
/// layer's every derivative falls (E4.2, E4.3), and so do both modes of an overdamped one (E4.4).
template <typename S>
class SlipTerms {
 public:
  /// @param theta, at    phase where the zone starts
  /// @param length, end  how long it may last, and the phase there
  SlipTerms(const LayerMotion<double>& layer, const FreeMotion<S>& motion, const Harmonic<S>& slow,
            const S& sigma, const S& theta, const Trig<S>& at, const S& length, const Trig<S>& end)
      : layer_(layer),
        motion_(motion),
        slow_{sigma * slow.k0, S(0.0), sigma * slow.kw, sigma * slow.ks},
        sigma_(sigma),
        theta_(theta),
        at_(at),
        length_(length),
        swing_(swing_of(slow)),
        least_share_(std::fmax(0.1, 1 - layer.decay_in_a_turn())),
        last_(slow_.at(S(0.0), end)),
        last_slope_(slow_.slope(end)) {}

  /// Value and derivatives alone.
  SampleOf<S> terms(const S& x) const {
    return bounded(quick_trig(S(theta_ + x)), own_motion(x), S(0.0));
  }

 protected:
  // h' and its three derivatives, and bounds of -sigma h', |h'''|, |h''''| from x on.
  struct Own {
    S rate, rate1, rate2, rate3, bound0, bound2, bound3;
  };

  SampleOf<S> bounded(const Trig<S>& a, const Own& own, const S& skip) const {
    const S slope = slow_.slope(a);
    return {slow_.at(S(0.0), a) + sigma_ * own.rate,
            slope + sigma_ * own.rate1,
            slow_.curvature(a) + sigma_ * own.rate2,
            swing_ + own.bound2,
            swing_ + own.bound3,
            skip,
            sigma_ * own.rate3 - slope};
  }

  static S swing_of(const Harmonic<S>& slow) {
    using std::sqrt;
    return sqrt(S(slow.kw * slow.kw + slow.ks * slow.ks));
  }

  // A march asks for it at each step.
  [[gnu::always_inline]] Own own_motion(const S& x) const {
    using std::exp;
    switch (layer_.kind()) {
      case LayerKind::oscillating: return oscillation(layer_.at(motion_, x));
      case LayerKind::elastic: return still();
      case LayerKind::relaxing: return modes(S(0.0), S(motion_.w * exp(S(layer_.slow() * x))));
      default: break;
    }
    return modes(S(motion_.u * exp(S(layer_.fast() * x))),
                 S(motion_.w * exp(S(layer_.slow() * x))));
  }

  Own own_start() const {
    switch (layer_.kind()) {
      case LayerKind::oscillating: return oscillation({motion_.u, motion_.w});
      case LayerKind::elastic: return still();
      default: return modes(motion_.u, motion_.w);
    }
  }

  static Own still() {
    const S zero(0.0);
    return {zero, zero, zero, zero, zero, zero, zero};
  }

  Own oscillation(const LayerState<S>& h) const {
    using std::sqrt;
    const double M = layer_.M, C = layer_.C, inverse = layer_.inverse_inertia();
    const S h2 = -(C * h.rate + h.e) * inverse, h3 = -(C * h2 + h.rate) * inverse,
            h4 = -(C * h3 + h2) * inverse, h5 = -(C * h4 + h3) * inverse;
    return {h.rate,
            h2,
            h3,
            h4,
            sqrt(S(h.rate * h.rate + M * h2 * h2)),
            sqrt(S(h3 * h3 + M * h4 * h4)),
            sqrt(S(h4 * h4 + M * h5 * h5))};
  }

  Own modes(const S& u, const S& w) const {
    using std::fabs, std::max;
    const double l1 = layer_.fast(), l2 = layer_.slow();
    const S fast = u * l1, slow = w * l2, fast2 = fast * l1 * l1, slow2 = slow * l2 * l2;
    return {fast + slow,
            fast * l1 + slow * l2,
            fast2 + slow2,
            fast2 * l1 + slow2 * l2,
            max(S(-sigma_ * fast), S(0.0)) + max(S(-sigma_ * slow), S(0.0)),
            fabs(fast2) + fabs(slow2),
            fabs(fast2 * l1) + fabs(slow2 * l2)};
  }

  // The lowest value that the harmonic part may have from here on.
  S lowest(const S& rest, const S& slow, const S& slope) const {
    using std::min;
    const auto may_turn = rest > 3.0 || (slope < 0.0 && last_slope_ > 0.0);
    return select(may_turn, slow_.k0 + slow_.kw - swing_, min(slow, last_));
  }

  // (E4.9) is worth its price where it may be less than `enough`.
  auto depth_may_be(const S& enough, const Own& own) const {
    return enough > least_share_ * own.bound0 && -sigma_ * own.rate < 0.5 * enough;
  }

  const LayerMotion<double>& layer_;
  FreeMotion<S> motion_;
  Harmonic<S> slow_;
  S sigma_;
  S theta_;
  Trig<S> at_;
  S length_;
  S swing_;              // rho
  double least_share_;   // of the bound of h'; below it no trough is looked for
  S last_, last_slope_;  // the harmonic part at the end of the length
};

/// The same with all that is known of its zeros.
class SlipCurve : public SlipTerms<double> {
 public:
  using SlipTerms::SlipTerms;

  CurveSample first() const { return sample(0, at_, own_start()); }
  CurveSample sample(double x) const { return sample(x, quick_trig(theta_ + x), own_motion(x)); }

 private:
  CurveSample sample(double x, const Trig<double>& a, const Own& own) const {
    const double slow = slow_.at(0, a);
    const bool may_skip = slow > least_share_ * own.bound0;
    return bounded(a, own, may_skip ? skip(length_ - x, slow, slow_.slope(a), own) : 0);
  }

  // (E4.6) How far the harmonic part mean + rho cos(u) stays above what the layer's own motion takes from it: all the
  // `rest` of the zone if its lowest value there does.
  double skip(double rest, double slow, double slope, const Own& own) const {
    const double least = lowest(rest, slow, slope);
    if (least > own.bound0 || least > depth(own, least)) return kNoZero;
    if (!(slow > own.bound0)) return 0;
    const double mean = slow_.k0 + slow_.kw;
    return std::acos((own.bound0 - mean) / swing_) - std::atan2(-slope, slow - mean);
  }

  // (E4.9) How far sigma h' goes below zero, where it may be less than `enough`. It is seldom asked for, and makes the
  // march longer if it is inline.
  [[gnu::noinline]] double depth(const Own& own, double enough) const {
    return depth_may_be(enough, own) ? layer_.depth(sigma_ * own.rate, sigma_ * own.rate1)
                                     : kNoZero;
  }
};

}  // namespace twum::inline v0_1::contact
