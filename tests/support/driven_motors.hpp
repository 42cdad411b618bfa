// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/test_motors.hpp"

#include <twum/core/motor_design.hpp>
#include <twum/core/parameters.hpp>

namespace twum::test {

/// A 60 mm motor with nine waves under a voltage, with an elastic layer and without the loss of its ceramic: numbers of the
/// size of motors one can buy.
inline MotorDesign driven_motor(double voltage = 120, double frequency = 40.8e3) {
  MotorDesign design = ring_motor();
  Stator& s = design.stator;
  s.frequency = frequency;
  s.voltage = voltage;
  s.resonance_frequency = 39e3;
  s.modal_mass = 0.025;
  s.modal_damping = 40;
  s.force_factor = 0.55;
  s.blocked_capacitance = 8.5e-9;
  s.loss_tangent = 0.01;
  design.layer = {};
  design.layer.thickness = 0.5e-3;
  design.layer.youngs_modulus = 0.9e9;
  design.layer.poisson_ratio = 0.38;
  design.layer.density = 1500;
  design.layer.given_inertia = 0;
  design.layer.given_shear_viscosity = 0;
  design.friction = {0.23, 0.23};
  design.preload = 170;
  return design;
}

/// The same with the whole layer: inertia and viscosity.
inline MotorDesign driven_motor_with_layer(double voltage = 120, double frequency = 40.8e3) {
  MotorDesign design = driven_motor(voltage, frequency);
  design.layer.given_inertia.reset();
  design.layer.given_shear_viscosity.reset();
  return design;
}

/// The same with unequal phases and modes, a heavy rotor and a sensor.
inline MotorDesign unequal_motor(MotorDesign design = driven_motor()) {
  design.stator.imbalance = Imbalance{1.04, -0.03, 4e-4};
  design.stator.sensor = Sensor{0.03, 0.5e-9, 0.2e-9, 50e3, 1.2};
  design.rotor.mass = 0.1;
  design.rotor.inertia = 7e-6;
  return design;
}

/// True for parameters that say nothing of a motor whose wave is given.
inline bool of_driven_stator(Parameter parameter) {
  using P = Parameter;
  switch (parameter) {
    case P::frequency_ratio:
    case P::voltage:
    case P::quality_factor:
    case P::resonance_frequency:
    case P::modal_mass:
    case P::force_factor:
    case P::blocked_capacitance:
    case P::loss_tangent:
    case P::voltage_ratio:
    case P::phase_error:
    case P::mode_splitting:
    case P::sensor_force_factor:
    case P::sensor_capacitance:
    case P::sensor_load_capacitance:
    case P::sensor_load_resistance:
    case P::sensor_position:
    case P::rotor_mass:
    case P::rotor_inertia: return true;
    default: return false;
  }
}

}  // namespace twum::test
