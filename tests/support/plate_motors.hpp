// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/driven_motors.hpp"
#include "support/stators.hpp"

namespace twum::test {

/// A driven motor whose stator is given by its geometry, with radii that are all different.
inline MotorDesign plate_motor() {
  MotorDesign design = driven_motor_with_layer(150);
  Stator& s = design.stator;
  s.geometry = distinct_stator();
  s.resonance_frequency.reset(), s.modal_mass.reset(), s.force_factor.reset();
  s.blocked_capacitance = 0;
  s.quality_factor = 150;
  s.frequency_ratio = 1.046;
  return design;
}

/// True for parameters of a stator given by its geometry that count without temperatures.
inline bool of_geometry(Parameter parameter) {
  return info(parameter).file_entry.starts_with("stator.geometry.") &&
         parameter > Parameter::axial_damping;  // those of heat stand before
}

}  // namespace twum::test
