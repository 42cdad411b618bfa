// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/driven_motors.hpp"
#include "support/plate_motors.hpp"

#include <twum/core/heat.hpp>
#include <twum/core/metrics.hpp>
#include <twum/core/motor_design.hpp>
#include <twum/core/parameters.hpp>

#include <cmath>

namespace twum::test {

/// The network N1 of the reference tables: a 60 mm motor with a bronze web on a flange in still air.
inline HeatNetwork usual_network() { return {22, 25, 130, 15, 0.333, 0.8, 0.25, 0.22, 0.03, 0.03}; }

/// A motor with this network, at 20 degC.
inline MotorDesign with_heat(MotorDesign design) {
  Thermal& t = design.thermal.emplace();
  const HeatNetwork n = usual_network();
  t.stator.heat_capacity = n.stator_capacity;
  t.rotor.heat_capacity = n.rotor_capacity;
  t.housing.heat_capacity = n.housing_capacity;
  t.conductances = {n.stator_contact,  n.lining,         n.stator_housing, n.rotor_housing,
                    n.housing_ambient, n.stator_ambient, n.rotor_ambient};
  return design;
}

inline constexpr double kZero = 273.15;  ///< 0 degC [K]

/// The motor of tests/data/motors/drive-60.yaml with the network N1.
inline MotorDesign warm_motor() {
  MotorDesign design = with_heat(driven_motor_with_layer());
  design.stator.quality_factor = 153;
  design.stator.modal_damping = 0;
  design.layer.loss_factor = 0.05;
  design.thermal->ambient = design.thermal->reference.emplace(kZero + 20);
  return design;
}

/// With the drift of the reference tables.
inline MotorDesign with_table(MotorDesign design) {
  ThermalDrift& a = design.thermal->drift;
  a.resonance_frequency = -2.2e-4, a.quality_factor = -3e-3, a.blocked_capacitance = 4e-3;
  a.loss_tangent = 5e-3, a.youngs_modulus = -3e-3, a.kinetic_friction = -1e-3;
  return design;
}

/// Friction that fades while the drive tracks the resonance.
inline MotorDesign fading_motor() {
  MotorDesign design = warm_motor();
  design.thermal->drift.kinetic_friction = -4e-3;
  design.thermal->drift.resonance_frequency = -2.2e-4;
  design.stator.frequency_ratio = 40.8e3 / 39e3;
  return design;
}

inline LoadPoint heat_load(double torque) { return {Argument::torque, torque}; }

inline MetricRequest metric_at_torque(Metric metric, double torque) {
  return {metric, Argument::torque, torque};
}

inline double part_off(double found, double right) {
  return std::fabs(found - right) / std::fabs(right);
}

/// True for what the stator's materials are in the heat network.
inline bool of_stator_heat(Parameter parameter) {
  return parameter == Parameter::substrate_conductivity ||
         parameter == Parameter::substrate_specific_heat ||
         parameter == Parameter::ceramic_specific_heat;
}

/// plate_motor() with the network N1, but for what follows from its geometry and materials.
inline MotorDesign warm_plate_motor() {
  MotorDesign design = with_heat(plate_motor());
  stator::StatorGeometry& g = *design.stator.geometry;
  g.substrate.conductivity = 77, g.substrate.specific_heat = 380, g.ceramic.specific_heat = 350;
  Thermal& t = *design.thermal;
  t.ambient = t.reference.emplace(kZero + 20);
  t.stator.heat_capacity.reset();
  t.conductances.stator_contact.reset(), t.conductances.stator_housing.reset();
  return design;
}

/// True for parameters that say nothing of a motor without temperatures or wear.
inline bool of_heat(Parameter parameter) {
  const std::string_view entry = info(parameter).file_entry;
  return entry.starts_with("thermal.") || entry.starts_with("wear.") ||
         parameter == Parameter::conductivity || of_stator_heat(parameter);
}

/// A motor that gives such a parameter.
inline MotorDesign motor_that_gives(Parameter parameter) {
  using P = Parameter;
  if (of_stator_heat(parameter)) return warm_plate_motor();
  MotorDesign design = warm_motor();
  Thermal& t = *design.thermal;
  design.layer.conductivity = 0.25;
  t.stator.temperature_limit = t.rotor.temperature_limit = 400;
  t.housing.temperature_limit = t.contact_temperature_limit = 400;
  design.wear = Wear{1e-15, 1e-17, 1e-4, {}, 1e5, 3e9};
  if (parameter == P::drift_modal_damping) design = with(design, P::modal_damping, 40);
  if (parameter == P::drift_shear_viscosity) design = with(design, P::shear_viscosity, 60);
  if (info(parameter).file_entry.starts_with("thermal.drift."))
    return with(design, parameter, 1e-3);
  if (!info(parameter).file_entry.starts_with("thermal.one_node.")) return design;
  design.thermal = Thermal{};
  design.thermal->one_node = OneNode{40, 0.5, 660};
  return design;
}

}  // namespace twum::test
