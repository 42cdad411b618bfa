// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/held_point.hpp>

namespace twum::inline v0_1::core {

/// The wave at the least voltage with which a drive of the design's frequency runs the motor, and where (Y5.4).
struct LeastVoltage {
  HeldPoint wave;  ///< its `voltage` is the least; its status says why there is none
  double speed;    ///< [rad/s]
};

/// With which the motor carries a torque at any speed: the minimum over the speed of the voltage that holds it there.
LeastVoltage least_voltage_at_torque(const MotorDesign& design, double torque);

/// With which a wave runs at a speed: the minimum of H over the amplitude beyond its last maximum. NaN where H has none,
/// so that each voltage has one wave; with mu_0 > mu, where the wave may end at a jump; and where it is unstable.
LeastVoltage least_voltage_at_speed(const MotorDesign& design, double speed);

}  // namespace twum::inline v0_1::core
