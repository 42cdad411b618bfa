// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/heat_motors.hpp"
#include "support/test_motors.hpp"

#include <twum/core/load.hpp>
#include <twum/core/motor_design.hpp>

namespace twum::test {

inline constexpr double kWearUnit = 1e-9;  ///< mm^3/(N m) [m^2/N]

/// The motor with a lining that wears, up to 100 um.
inline MotorDesign wearing(MotorDesign design, double spring = 0, double k = 1e-6) {
  Wear& wear = design.wear.emplace();
  wear.specific_wear = k * kWearUnit;
  wear.depth_limit = 100e-6;
  wear.preload_spring = spring;
  return design;
}

/// drive-60 of the reference tables, under its voltage.
inline MotorDesign driven_with_slices(int slices) {
  MotorDesign design = warm_motor();
  design.thermal.reset();
  design.stator.radial_slices = slices;
  return design;
}

/// The motor elastic-layer of the reference tables, which has a shear modulus of its own.
inline MotorDesign elastic_layer(int slices) {
  MotorDesign design = elastic(ring_motor());
  design.layer.given_shear_modulus = 1.1e9;
  design.stator.radial_slices = slices;
  return design;
}

inline LoadPoint torque_load(double torque) { return {Argument::torque, torque, 0}; }

}  // namespace twum::test
