// SPDX-License-Identifier: Apache-2.0
#include <twum/core/contact_slopes.hpp>

#include "design/held_traps.hpp"
#include "drive/driven_wave.hpp"
#include "point/slice_count.hpp"

#include <numbers>

namespace twum::inline v0_1 {

using namespace core;

namespace {

using contact::kInAmplitude;
using contact::kInSpeed;
using contact::MotionDual;

// The viscosity of a loss factor would follow the frequency.
MotorDesign with_fixed_viscosity(MotorDesign design) {
  design.layer.given_shear_viscosity = shear_viscosity(design);
  return design;
}

// A number from its duals in (A, Omega) and in (A, omega).
ContactSlopes::Number number(const MotionDual& in_speed, const MotionDual& in_omega) {
  return {in_speed.v, in_speed.d[kInAmplitude], in_speed.d[kInSpeed],
          2 * std::numbers::pi * in_omega.d[kInSpeed]};
}

}  // namespace

ContactSlopes contact_slopes(const Motor& motor, const OperatingConditions& at) {
  const HeldTraps held;
  ContactSlopes slopes;
  slopes.status = motor.operating_point(at).status;  // which also checks the conditions
  if (slopes.status != PointStatus::ok) return slopes;
  const MotorDesign design = with_fixed_viscosity(motor.design());
  const double rate = 2 * std::numbers::pi * at.frequency;
  const DrivenWaves waves = DrivenWaves(design, track_rule(design)).at_frequency(rate);
  const SolvedPoint point = solve_point(waves.motor(at.amplitude), at.speed);
  const auto in_speed = waves.moving(point, at.amplitude, at.speed, Continued::speed).numbers;
  const auto in_omega = waves.moving(point, at.amplitude, at.speed, Continued::frequency).numbers;
  const MotionDual amplitude = MotionDual::variable(at.amplitude, kInAmplitude);
  const MotionDual omega = MotionDual::variable(rate, kInSpeed);
  slopes.torque = number(in_speed.torque, in_omega.torque);
  slopes.reactive_force = number(in_speed.reactive_force, in_omega.reactive_force);
  slopes.active_force = number(in_speed.stator_power / (rate * amplitude),
                               in_omega.stator_power / (omega * amplitude));  // (D1.2)
  return slopes;
}

}  // namespace twum::inline v0_1
