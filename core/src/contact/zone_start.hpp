// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/contact_numbers.hpp"
#include "contact/first_zero.hpp"
#include "contact/lap.hpp"

#include <twum/core/zone.hpp>

#include <cmath>

namespace twum::inline v0_1::contact {

template <typename S>
S pressure(const ContactNumbers<S>& n, const Trig<S>& at) {
  return n.peak - at.versine;
}

/// v_rel = 0 (T4.2): e' = s (cos theta - V).
template <typename S>
S sticking_rate(const ContactNumbers<S>& n, const Trig<S>& at) {
  return n.stick_rate * ((1.0 - n.speed_ratio) - at.versine);
}

/// Sign of v_rel while a zone slips.
inline double sign_of(ZoneState zone) { return -static_cast<double>(zone); }

inline ZoneState slipping(double sign_of_v_rel) {
  return sign_of_v_rel < 0 ? ZoneState::slip_plus : ZoneState::slip_minus;
}

/// A zone that begins, and how the functions whose zeros end it begin: of slip v_rel, of stick what is left to the
/// threshold on either side.
struct ZoneBegin {
  ZoneState zone;
  StartOrder slip{StartOrder::positive};
  StartOrder plus_side{StartOrder::positive}, minus_side{StartOrder::positive};
};

/// Which zone begins (theory section 4; events.md, section 2): decided by rates where pressures are near zero.
template <typename S>
class ZoneStart {
 public:
  ZoneStart(const ContactNumbers<S>& numbers, const LayerMotion<S>& layer)
      : n_(numbers), layer_(layer) {}

  /// The zone of the lap before goes on, unless a Newton step has moved the state out of it.
  ZoneBegin carry_on(ZoneState zone, const LapPlace<S>& p) const {
    if (zone == ZoneState::stick) {
      const double traction = sticking_traction(p);
      if (holds(traction, p)) return stick();
      return slip(traction > 0 ? -1 : 1,
                  layer_.has_inertia() ? StartOrder::zero : StartOrder::positive);
    }
    const double sigma = sign_of(zone);
    if (sigma * slip_rate(sigma, p) > 0) return slip(sigma, StartOrder::positive);
    return enter(p);
  }

  /// At the edge p = 0 and the layer comes with what the free flight left: rates decide.
  ZoneBegin enter(const LapPlace<S>& p) const {
    const double rate = value_of(sticking_rate(n_, p.at));
    if (layer_.has_inertia()) return enter_at_rate(value_of(p.layer.rate) - rate, p);
    if (n_.full) return enter_under_pressure(p);
    if (layer_.kind() == LayerKind::elastic) return enter_by_slopes(rate, StartOrder::positive);
    const double C = value_of(layer_.C), relative_rate = -value_of(p.layer.e) / C - rate;
    if (relative_rate != 0) return enter_at_rate(relative_rate, p);
    return enter_by_slopes(rate + C * value_of(n_.stick_rate) * value_of(n_.edge.sin),
                           StartOrder::zero);
  }

  ZoneBegin after_slip(double sigma, const LapPlace<S>& p) const {
    if (!layer_.has_inertia()) {
      // With mu_0 = mu the traction leaves its threshold where slip ends: at once with damping, from rest
      // relative to it in an elastic layer.
      const StartOrder touching = has_static_excess()                   ? StartOrder::positive
                                  : layer_.kind() == LayerKind::elastic ? StartOrder::double_zero
                                                                        : StartOrder::zero;
      return sigma < 0 ? stick(touching, StartOrder::positive)
                       : stick(StartOrder::positive, touching);
    }
    return holds(sticking_traction(p), p) ? stick() : slip(-sigma, StartOrder::zero);
  }

  /// @param iota  sign of the traction at its threshold; an elastic layer has snapped before
  ZoneBegin after_stick(double iota, const LapPlace<S>& p) const {
    const double sigma = -iota;
    if (layer_.has_inertia())
      return slip(sigma, has_static_excess() ? StartOrder::zero : StartOrder::double_zero);
    if (layer_.kind() != LayerKind::elastic)
      return slip(sigma, has_static_excess() ? StartOrder::positive : StartOrder::zero);
    // The slip branch holds if it gives v_rel its sign; otherwise the layer sticks again.
    if (sigma * slip_rate(sigma, p) > 0 || !has_static_excess())
      return slip(sigma, StartOrder::positive);
    return stick();
  }

  bool has_static_excess() const { return value_of(n_.threshold) > value_of(n_.kinetic); }

 private:
  static ZoneBegin slip(double sigma, StartOrder order) { return {slipping(sigma), order}; }
  static ZoneBegin stick(StartOrder plus_side = StartOrder::positive,
                         StartOrder minus_side = StartOrder::positive) {
    return {ZoneState::stick, StartOrder::positive, plus_side, minus_side};
  }

  double sticking_traction(const LapPlace<S>& p) const {
    return value_of(p.layer.e) + value_of(layer_.C) * value_of(sticking_rate(n_, p.at)) -
           value_of(layer_.M) * value_of(n_.stick_rate) * value_of(p.at.sin);
  }

  bool holds(double traction, const LapPlace<S>& p) const {
    return std::fabs(traction) <= value_of(n_.threshold) * value_of(pressure(n_, p.at));
  }

  // v_rel s / V0 of a layer that slips with sign sigma from here.
  double slip_rate(double sigma, const LapPlace<S>& p) const {
    const double rate = value_of(sticking_rate(n_, p.at)), mu = value_of(n_.kinetic);
    if (layer_.has_inertia()) return value_of(p.layer.rate) - rate;
    if (layer_.kind() == LayerKind::elastic) return sigma * mu * value_of(p.at.sin) - rate;
    return (-sigma * mu * value_of(pressure(n_, p.at)) - value_of(p.layer.e)) / value_of(layer_.C) -
           rate;
  }

  // Traction and threshold begin at zero: the layer sticks if the traction of stick rises no faster.
  ZoneBegin enter_by_slopes(double gain, StartOrder order) const {
    const double allowed = value_of(n_.kinetic) * value_of(n_.edge.sin);
    if (gain > allowed) return slip(-1, order);
    if (gain < -allowed) return slip(+1, order);
    return stick(StartOrder::zero, StartOrder::zero);
  }

  ZoneBegin enter_at_rate(double relative_rate, const LapPlace<S>& p) const {
    if (relative_rate != 0) return slip(relative_rate < 0 ? -1 : 1, StartOrder::positive);
    if (n_.full) return enter_under_pressure(p);
    return slip(sticking_traction(p) > 0 ? -1 : 1, StartOrder::zero);
  }

  // Full contact, layer without relative velocity: it sticks if it can.
  ZoneBegin enter_under_pressure(const LapPlace<S>& p) const {
    const double traction = sticking_traction(p);
    return holds(traction, p) ? stick() : slip(traction > 0 ? -1 : 1, StartOrder::positive);
  }

  const ContactNumbers<S>& n_;
  const LayerMotion<S>& layer_;
};

}  // namespace twum::inline v0_1::contact
