// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motor.hpp>

#include <algorithm>
#include <cmath>

namespace twum::test {

/// mu_0 F_N r [N m] (T7.8), the scale of torques.
inline double torque_scale(const MotorDesign& design) {
  return design.friction.threshold * design.preload * design.stator.contact_radius;
}

/// mu_0 F_N max(V0, |U|) [W] (T7.11), the scale of powers at one speed.
inline double power_scale(const Motor& motor, double speed) {
  return torque_scale(motor.design()) * std::max(motor.crest_speed(), std::abs(speed));
}

/// What is left of the identity (T7.10) [W].
inline double imbalance(const OperatingPoint& point) {
  return point.stator_power - point.output_power - point.friction_power - point.layer_loss;
}

inline bool all_finite(const OperatingPoint& point) {
  return std::isfinite(point.torque) && std::isfinite(point.output_power) &&
         std::isfinite(point.stator_power) && std::isfinite(point.friction_power) &&
         std::isfinite(point.layer_loss) && std::isfinite(point.stator_loss) &&
         std::isfinite(point.wear_intensity) && std::isfinite(point.stick_fraction);
}

}  // namespace twum::test
