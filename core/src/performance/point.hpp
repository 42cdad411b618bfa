// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/periodic_state.hpp"
#include "performance/motor_model.hpp"

#include <twum/core/performance/motor.hpp>

#include <cmath>
#include <cstdint>
#include <vector>

namespace twum::performance {

/// Numbers of an operating point in S; the other powers follow from these (T7.1).
template <typename S>
struct PointNumbers {
  S torque, stator_power, friction_power, layer_loss, stick_fraction;
  S reactive_force;  ///< Re F, the contact's force on the wave in phase with its displacement (D1.1) [N]
};

/// What goes in and does not come out (T7.10) [W]; zero but for rounding.
inline double excess(const PointNumbers<double>& n, double speed) {
  return n.stator_power - n.torque * speed - n.friction_power - n.layer_loss;
}

/// True if an efficiency can be told from an input power: it is positive and the powers balance (T7.10) up to 1e-6 of it.
/// At no-load both powers of the quotient may vanish in rounding.
inline bool is_known(double input, double excess) {
  return input > 0 && std::fabs(excess) <= 1e-6 * input;
}

/// Where the search for a neighbouring point may begin: the layer as it enters the contact.
struct WarmStart {
  contact::LapEntry<double> entry;

  /// From `a` on through `b`, by t times their distance beyond `b`.
  static WarmStart beyond(const WarmStart& a, const WarmStart& b, double t) {
    const auto &p = a.entry.layer, &q = b.entry.layer;
    WarmStart start = b;
    start.entry.layer = {q.e + t * (q.e - p.e), q.rate + t * (q.rate - p.rate)};
    return start;
  }
};

/// The contact at one operating point. What it is made of, today one slice of the track, only its members know.
class SolvedPoint {
 public:
  SolvedPoint() = default;

  PointNumbers<double> numbers;
  PointStatus status{PointStatus::ok};
  /// Trivial or locked at rest: in closed form, no periodic state behind it.
  bool special{false};

  /// The whole contact slips one way.
  bool slips_one_way() const { return !special && state_.lap.one_slip; }
  /// The whole contact slips and drives: the torque is on its plateau.
  bool drives() const { return slips_one_way() && state_.lap.first == ZoneState::slip_plus; }
  /// Fingerprint of the sequence of zones.
  std::uint64_t signature() const { return special ? 0 : state_.lap.itinerary; }
  /// Length of the shortest zone [rad].
  double shortest_zone() const { return state_.lap.shortest; }
  /// Zones followed to find it: what the search cost.
  long zones_followed() const { return state_.zones; }
  WarmStart start() const { return {state_.entry}; }

  /// The numbers with derivatives in kModelParameters and the speed; S is ModelDual or ModelDual2. The contact is
  /// differentiated in its own seven numbers and chained.
  template <typename S>
  PointNumbers<S> differentiated(const DrivenMotor<S>& motor, const S& speed) const;
  /// The numbers with derivatives in speed.
  PointNumbers<contact::SpeedDual> differentiated(const DrivenMotor<double>& motor,
                                                  const contact::SpeedDual& speed) const;

  /// Zones from contact entry to exit.
  std::vector<Zone> zones(const DrivenMotor<double>& motor, double speed) const;
  /// Fields at equally spaced phases -pi .. pi.
  std::vector<FieldSample> fields(const DrivenMotor<double>& motor, double speed,
                                  int samples) const;

 private:
  friend SolvedPoint solve_point(const DrivenMotor<double>&, double, const WarmStart*, double);
  SolvedPoint(const contact::ContactNumbers<double>& n, const WarmStart* guess, double accuracy);
  static SolvedPoint of_special(const DrivenMotor<double>& motor, double speed);
  static SolvedPoint of_rubbing(const DrivenMotor<double>& motor, double speed,
                                const WarmStart* guess, double accuracy);

  template <typename S, typename R>
  PointNumbers<R> dimensional(const DrivenMotor<S>& motor,
                              const contact::ContactMeans<R>& means) const;

  contact::PeriodicState state_;  // undefined for special points
};

/// Solves one operating point.
/// @param guess     what a neighbouring point says; null: the layer enters at rest
/// @param accuracy  of the periodic state, as find_periodic_state()
SolvedPoint solve_point(const DrivenMotor<double>& motor, double speed,
                        const WarmStart* guess = nullptr, double accuracy = 0);

/// True if the whole contact sticks at rest (theory section 10).
template <typename S>
bool locks_at_rest(const DrivenMotor<S>& motor);

/// Points without a periodic state to search for: trivial motors at any speed, locked ones at rest.
template <typename S, typename R>
PointNumbers<R> special_point(const DrivenMotor<S>& motor, const R& speed);

/// Where the whole contact slips one way the torque is +-mu F_N r, whatever the layer does: then the derivatives of all
/// else are exactly zero.
template <typename S, typename R>
PointNumbers<R> SolvedPoint::dimensional(const DrivenMotor<S>& m,
                                         const contact::ContactMeans<R>& means) const {
  const S power = power_scale(m);
  R torque = torque_scale(m) * means.traction;
  if (slips_one_way()) torque = R(static_cast<double>(state_.lap.first) * slipping_torque(m));
  return {torque,
          power * means.stator_power,
          power * means.friction_power,
          power * means.layer_loss,
          means.stick_length / (2.0 * m.contact.half_angle),
          m.pressure_force + wave_force_scale(m) * means.reactive_force};
}

}  // namespace twum::performance
