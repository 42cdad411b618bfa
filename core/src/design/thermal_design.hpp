// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/parameters.hpp>

#include <array>
#include <string>

namespace twum::inline v0_1 {

/// The thermal block, made if it is missing.
Thermal& thermal_of(MotorDesign& design);

/// T_ref, at which the design's parameters hold [K]; NaN without a thermal block.
double reference_temperature(const MotorDesign& design);

/// G_l, as given or from the layer's conductivity (H1.6) [W/K]; NaN where neither is.
double lining_conductance(const MotorDesign& design);

/// The first thing that is wrong with the thermal block, as complaints(); empty if nothing is.
std::string thermal_complaint(const MotorDesign& design);

/// The first thing that is wrong with the phases of the operation, likewise.
std::string operation_complaint(const MotorDesign& design);

/// Temperatures of a motor that its parameters follow.
enum class ThermalNode : unsigned char { stator, contact, lining };

/// A coefficient of (H3.1), and the parameter that follows it.
struct DriftRow {
  Parameter coefficient, parameter;
  ThermalNode node;
};

/// Every one.
inline constexpr std::array<DriftRow, 10> kDrifts{{
    {Parameter::drift_resonance_frequency, Parameter::resonance_frequency, ThermalNode::stator},
    {Parameter::drift_quality_factor, Parameter::quality_factor, ThermalNode::stator},
    {Parameter::drift_modal_damping, Parameter::modal_damping, ThermalNode::stator},
    {Parameter::drift_force_factor, Parameter::force_factor, ThermalNode::stator},
    {Parameter::drift_blocked_capacitance, Parameter::blocked_capacitance, ThermalNode::stator},
    {Parameter::drift_loss_tangent, Parameter::loss_tangent, ThermalNode::stator},
    {Parameter::drift_youngs_modulus, Parameter::youngs_modulus, ThermalNode::lining},
    {Parameter::drift_loss_factor, Parameter::loss_factor, ThermalNode::lining},
    {Parameter::drift_shear_viscosity, Parameter::shear_viscosity, ThermalNode::lining},
    {Parameter::drift_kinetic_friction, Parameter::kinetic_friction, ThermalNode::contact},
}};

/// True if the design gives a coefficient other than 0.
bool drifts(const MotorDesign& design);

}  // namespace twum::inline v0_1
