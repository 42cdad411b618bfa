// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/lap.hpp"
#include "contact/zone_curves.hpp"
#include "contact/zone_start.hpp"

namespace twum::inline v0_1::contact {

/// Where the ends of zones come from.
enum class Ends : unsigned char {
  searched,   ///< the first root of a function; given by a sequence, if there is one
  confirmed,  ///< those near the ones of a sequence, once they are proven to be the first
  trusted     ///< those near the ones of a sequence, without proof
};

/// Finds where zones end: the first zero of v_rel in slip, of the reserve to the threshold on either side in stick.
/// Lengths are NaN where too many samples would be needed, kNoZero where the zone lasts to the exit.
template <typename S, Ends kEnds>
class ZoneEnds {
 public:
  ZoneEnds(const ContactNumbers<S>& numbers, const LayerMotion<S>& layer,
           const ZoneSequence* sequence)
      : n_(numbers),
        layer_(layer),
        sequence_(sequence && sequence->complete() ? sequence : nullptr) {}

  /// The sequence's end of a zone, if it has one like it at this index.
  const ZoneSequence::End* known(ZoneState zone, int index) const {
    const bool has = sequence_ && index < sequence_->count && sequence_->ends[index].zone == zone;
    return has ? sequence_->ends + index : nullptr;
  }

  /// @param slow   what v_rel is beside the layer's own motion
  /// @param known  the zone's end in the sequence; null if it has none
  double slip_end(const FreeMotion<S>& motion, const Harmonic<S>& slow, const ZoneBegin& zone,
                  const LapPlace<S>& from, const ZoneSequence::End* known) {
    if (is_given(known)) return known ? known->length : kNoZero;
    const FreeMotion<double> own{value_of(motion.u), value_of(motion.w)};
    const double length = value_of(n_.half_angle) - value_of(from.theta);
    const auto& layer = layer_.values();  // lives as long as the curve
    const SlipCurve curve(layer, own, slow.values(), sign_of(zone.zone), value_of(from.theta),
                          values(from.at), length, values(n_.edge));
    return find_zero(curve, length, zone.slip, near(known, 0));
  }

  /// Newton steps in S from the root in double: the value stays, the derivatives come in.
  S settled_slip_end(const FreeMotion<S>& motion, const Harmonic<S>& slow, const LapPlace<S>& from,
                     double x) const {
    S length(x);
    for (int i = 0; i < kDualDepth<S>; ++i) {
      const S theta = from.theta + length;
      const Trig<S> a = trig(theta);
      const LayerState<S> h = layer_.at(motion, length);
      const S rate2 = layer_.kind() == LayerKind::elastic ? S(0.0)
                      : layer_.kind() == LayerKind::relaxing
                          ? S(-h.rate / layer_.C)
                          : S(-(layer_.C * h.rate + h.e) / layer_.M);
      length = newton_step(length, S(slow.at(theta, a) + h.rate), S(slow.slope(a) + rate2), x);
    }
    return length;
  }

  /// The side that the traction would reach at the exit comes first. The other is mostly ruled out at a
  /// glance.
  /// @param t  traction of the zone
  ZoneSequence::End stick_end(const Harmonic<S>& t, const ZoneBegin& zone, const LapPlace<S>& from,
                              const ZoneSequence::End* known) {
    if (is_given(known)) return known ? *known : ended(kNoZero, 0);
    const Harmonic<double> traction = t.values();
    const double exit = value_of(n_.half_angle), length = exit - value_of(from.theta);
    if constexpr (kEnds == Ends::trusted) {
      return ended(find_zero(stick_curve(t, from, known->side), length, {}, known->length),
                   known->side);
    }
    const auto side = [&](double iota, double within, const Trig<double>& end) {
      return stick_end_on(iota, t, zone, from, within, end, near(known, iota));
    };
    const double likely = traction.at(exit, values(n_.edge)) < 0 ? -1 : 1;
    const double first = side(likely, length, values(n_.edge));
    if (std::isnan(first)) return ended(first, 0);
    const double second = first == kNoZero
                              ? side(-likely, length, values(n_.edge))
                              : side(-likely, first, quick_trig(value_of(from.theta) + first));
    return second == kNoZero ? ended(first, likely) : ended(second, -likely);
  }

  /// As settled_slip_end().
  S settled_stick_end(const Harmonic<S>& t, const LapPlace<S>& from,
                      const ZoneSequence::End& end) const {
    const Harmonic<S> f = reserve(n_, t, end.side);
    S length(end.length);
    for (int i = 0; i < kDualDepth<S>; ++i) {
      const S theta = from.theta + length;
      const Trig<S> a = trig(theta);
      length = newton_step(length, f.at(theta, a), f.slope(a), end.length);
    }
    return length;
  }

 private:
  static constexpr long kMaxSamples = 4'000'000;

  static Trig<double> values(const Trig<S>& a) {
    return {value_of(a.sin), value_of(a.cos), value_of(a.versine)};
  }

  static ZoneSequence::End ended(double length, double side) {
    return {length, static_cast<float>(side), ZoneState::stick};
  }

  // True if the sequence's end needs no search.
  bool is_given(const ZoneSequence::End* known) const {
    return kEnds == Ends::searched ? sequence_ != nullptr
                                   : kEnds == Ends::trusted && known->length == kNoZero;
  }

  // Where a search may begin.
  static double near(const ZoneSequence::End* known, double side) {
    return kEnds != Ends::searched && known && known->side == side ? known->length : kNoZero;
  }

  template <typename Curve>
  double find_zero(const Curve& curve, double length, StartOrder order, double near) {
    if constexpr (kEnds == Ends::searched) {
      return first_zero(curve, length, order, samples_, kMaxSamples);
    } else if constexpr (kEnds == Ends::confirmed) {
      return first_zero(curve, length, order, samples_, kMaxSamples,
                        known_zero(curve, near, length));
    } else {
      return followed_zero(curve, near, length);
    }
  }

  static S newton_step(const S& x, const S& f, const S& slope, double value) {
    if (value_of(slope) == 0) return x;
    return with_value(S(x - with_value(f, 0.0) / slope), value);
  }

  StickCurve stick_curve(const Harmonic<S>& t, const LapPlace<S>& from, double iota) const {
    return {reserve(n_, t, iota).values(), value_of(from.theta), values(from.at)};
  }

  double stick_end_on(double iota, const Harmonic<S>& t, const ZoneBegin& zone,
                      const LapPlace<S>& from, double length, const Trig<double>& end,
                      double near) {
    const StickCurve curve = stick_curve(t, from, iota);
    const StartOrder order = iota > 0 ? zone.plus_side : zone.minus_side;
    const StickCurve::Glance glance = curve.glance(length, order, end);
    if (glance == StickCurve::Glance::no_zero) return kNoZero;
    if (glance == StickCurve::Glance::one_zero) return curve.only_zero(length, near);
    return find_zero(curve, length, order, near);
  }

  const ContactNumbers<S>& n_;
  const LayerMotion<S>& layer_;
  const ZoneSequence* sequence_;
  long samples_{0};
};

}  // namespace twum::inline v0_1::contact
