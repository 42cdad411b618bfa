// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/periodic_state.hpp"
#include "performance/motor_model.hpp"

#include <twum/core/performance/motor.hpp>

#include <cmath>

namespace twum::performance {

/// Numbers of an operating point in S; the other powers follow from these (T7.1).
template <typename S>
struct PointNumbers {
  S torque, stator_power, friction_power, layer_loss, stick_fraction;
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

/// An operating point with what its search found.
struct SolvedPoint {
  contact::PeriodicState state;  ///< undefined for trivial and locked points
  PointNumbers<double> numbers;
  PointStatus status{PointStatus::ok};
  bool special{false};  ///< trivial or locked at rest: in closed form, no periodic state behind it

  SolvedPoint() = default;
  /// Of a motor that rubs: its numbers and its status follow from this state.
  SolvedPoint(const contact::ContactNumbers<double>& n, const contact::LayerMotion<double>& layer,
              const contact::LapEntry<double>* guess, double accuracy)
      : state(contact::find_periodic_state(n, layer, guess, accuracy)) {}
};

/// Solves one operating point.
/// @param guess     state at entry at a neighbouring speed; null: at rest
/// @param accuracy  of the periodic state, as find_periodic_state()
SolvedPoint solve_point(const MotorModel<double>& model, double speed,
                        const contact::LapEntry<double>* guess = nullptr, double accuracy = 0);

/// True if the whole contact sticks at rest (theory section 10).
template <typename S>
bool locks_at_rest(const MotorModel<S>& model);

/// Points without a periodic state to search for: trivial motors at any speed, locked ones at rest.
template <typename S, typename R>
PointNumbers<R> special_point(const MotorModel<S>& model, const R& speed);

/// Dimensional numbers from the contact's means. Where the whole contact slips one way the torque is
/// +-mu F_N r, whatever the layer does: then the derivatives of all else are exactly zero.
template <typename S, typename R, typename L>
PointNumbers<R> dimensional(const MotorModel<S>& m, const contact::ContactMeans<R>& means,
                            const contact::Lap<L>& lap) {
  const S power = power_scale(m);
  R torque = torque_scale(m) * means.traction;
  if (lap.one_slip) torque = R(static_cast<double>(lap.first) * (m.kinetic * m.preload * m.r));
  return {torque, power * means.stator_power, power * means.friction_power,
          power * means.layer_loss, means.stick_length / (2.0 * m.contact.half_angle)};
}

}  // namespace twum::performance
