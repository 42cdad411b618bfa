// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "design/motor_rows.hpp"
#include "design/stator_heat.hpp"
#include "design/thermal_design.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <type_traits>

namespace twum::inline v0_1 {
namespace thermal_rows {

using P = Parameter;
using motor_rows::kNoAlternative;

template <typename T>
inline constexpr bool kOptional = false;
template <typename T>
inline constexpr bool kOptional<std::optional<T>> = true;

/// The number at the end of a path of members; NaN where a block on the way is missing.
template <auto first, auto... rest, typename Block>
double number_at(const Block& block) {
  const auto& member = block.*first;
  using Member = std::decay_t<decltype(member)>;
  if constexpr (sizeof...(rest) == 0 && kOptional<Member>) return member.value_or(kNoValue);
  if constexpr (sizeof...(rest) == 0 && !kOptional<Member>) return member;
  if constexpr (sizeof...(rest) > 0 && kOptional<Member>)
    return member ? number_at<rest...>(*member) : kNoValue;
  if constexpr (sizeof...(rest) > 0 && !kOptional<Member>) return number_at<rest...>(member);
}

/// Sets it, and makes the blocks on the way that are missing.
template <auto first, auto... rest, typename Block>
void set_at(Block& block, double value) {
  auto& member = block.*first;
  if constexpr (sizeof...(rest) == 0) {
    member = value;
  } else if constexpr (kOptional<std::decay_t<decltype(member)>>) {
    if (!member) member.emplace();
    set_at<rest...>(*member, value);
  } else {
    set_at<rest...>(member, value);
  }
}

/// A number of the thermal block; none without it.
template <auto... path>
constexpr ParameterPlace of_heat() {
  return {[](const MotorDesign& d) { return number_at<&MotorDesign::thermal, path...>(d); },
          nullptr,
          [](MotorDesign& d, double value) {
            set_at<path...>(thermal_of(d), value);
            return true;
          }};
}

/// True if the number at the end of a path is given, of a parameter whose value may follow from others.
template <auto... path>
bool is_there(const MotorDesign& design) {
  return !std::isnan(number_at<&MotorDesign::thermal, path...>(design));
}

/// A number of the stator's materials for heat; null without a geometry.
template <auto block, auto member, typename Design>
auto* of_material(Design& design) {
  auto& geometry = design.stator.geometry;
  return geometry ? &((*geometry).*block.*member) : nullptr;
}

template <auto block, auto member>
bool material_has(const MotorDesign& design) {
  const auto* number = of_material<block, member>(design);
  return number && number->has_value();
}

template <auto block, auto member>
constexpr ParameterPlace of_stator() {
  return ParameterPlace{[](const MotorDesign& d) {
                          const auto* number = of_material<block, member>(d);
                          return number ? number->value_or(kNoValue) : kNoValue;
                        },
                        material_has<block, member>,
                        [](MotorDesign& d, double value) {
                          auto* number = of_material<block, member>(d);
                          if (number) *number = value;
                          return number != nullptr;
                        }};
}

/// Rows of the parameter table for heat. Every motor does without them.
inline constexpr std::array kThermalRows{std::to_array<ParameterRow>({
    {{P::conductivity, "conductivity", "", "W/(m.K)", "contact_layer.conductivity", 1e-3, 1e4,
      false, false, kNoAlternative, "0.25 W/(m.K)",
      "thermal conductivity of the lining; gives conductance_lining",
      "a tenth of the best foam to five times diamond", "none", false},
     optional_number<&ContactLayer::conductivity>()},
    {{P::substrate_conductivity, "substrate_conductivity", "", "W/(m.K)",
      "stator.geometry.substrate.conductivity", 1e-3, 1e4, false, false, kNoAlternative,
      "77 W/(m.K)", "thermal conductivity of the metal", "as conductivity", "none", false},
     of_stator<&stator::StatorGeometry::substrate, &stator::Substrate::conductivity>()},
    {{P::substrate_specific_heat, "substrate_specific_heat", "", "J/(kg.K)",
      "stator.geometry.substrate.specific_heat", 1, 1e5, false, false, kNoAlternative,
      "380 J/(kg.K)", "specific heat of the metal", "metals at 10 K to hydrogen", "none", false},
     of_stator<&stator::StatorGeometry::substrate, &stator::Substrate::specific_heat>()},
    {{P::ceramic_specific_heat, "ceramic_specific_heat", "", "J/(kg.K)",
      "stator.geometry.ceramic.specific_heat", 1, 1e5, false, false, kNoAlternative, "350 J/(kg.K)",
      "specific heat of the piezoceramic", "as for metals", "none", false},
     of_stator<&stator::StatorGeometry::ceramic, &stator::Ceramic::specific_heat>()},
    {{P::ambient_temperature, "ambient_temperature", "", "K", "thermal.ambient", 1, 3000, false,
      false, kNoAlternative, "20 degC", "temperature around the motor",
      "from liquid helium to beyond any ceramic", "20 degC", false, true},
     of_heat<&Thermal::ambient>()},
    {{P::reference_temperature, "reference_temperature", "", "K", "thermal.reference", 1, 3000,
      false, false, kNoAlternative, "20 degC",
      "temperature at which the values of the motor file hold", "as ambient_temperature", "ambient",
      false, true},
     of_heat<&Thermal::reference>()
         .read_by(reference_temperature)
         .used_if(is_there<&Thermal::reference>)},
    {{P::stator_heat_capacity, "stator_heat_capacity", "", "J/K", "thermal.stator.heat_capacity",
      1e-9, 1e9, false, false, kNoAlternative, "25 J/K", "heat capacity of metal and ceramic",
      "from a silicon disc of 10 um to 2000 t of steel",
      "the geometry's; the model with three masses needs it", false},
     of_heat<&Thermal::stator, &ThermalBody::heat_capacity>()
         .read_by(stator_heat_capacity)
         .used_if(is_there<&Thermal::stator, &ThermalBody::heat_capacity>)},
    {{P::stator_temperature_limit, "stator_temperature_limit", "", "K", "thermal.stator.limit", 1,
      3000, false, false, kNoAlternative, "80 degC", "highest stator temperature",
      "as ambient_temperature", "no limit", false, true},
     of_heat<&Thermal::stator, &ThermalBody::temperature_limit>()},
    {{P::rotor_heat_capacity, "rotor_heat_capacity", "", "J/K", "thermal.rotor.heat_capacity", 1e-9,
      1e9, false, false, kNoAlternative, "25 J/K", "heat capacity of the rotor",
      "from a silicon disc of 10 um to 2000 t of steel",
      "none; the model with three masses needs it", false},
     of_heat<&Thermal::rotor, &ThermalBody::heat_capacity>()},
    {{P::rotor_temperature_limit, "rotor_temperature_limit", "", "K", "thermal.rotor.limit", 1,
      3000, false, false, kNoAlternative, "80 degC", "highest rotor temperature",
      "as ambient_temperature", "no limit", false, true},
     of_heat<&Thermal::rotor, &ThermalBody::temperature_limit>()},
    {{P::housing_heat_capacity, "housing_heat_capacity", "", "J/K", "thermal.housing.heat_capacity",
      1e-9, 1e9, false, false, kNoAlternative, "25 J/K",
      "heat capacity of the housing and its mount",
      "from a silicon disc of 10 um to 2000 t of steel",
      "none; the model with three masses needs it", false},
     of_heat<&Thermal::housing, &ThermalBody::heat_capacity>()},
    {{P::housing_temperature_limit, "housing_temperature_limit", "", "K", "thermal.housing.limit",
      1, 3000, false, false, kNoAlternative, "80 degC", "highest housing temperature",
      "as ambient_temperature", "no limit", false, true},
     of_heat<&Thermal::housing, &ThermalBody::temperature_limit>()},
    {{P::contact_temperature_limit, "contact_temperature_limit", "", "K", "thermal.contact.limit",
      1, 3000, false, false, kNoAlternative, "120 degC", "highest temperature of the sliding face",
      "as ambient_temperature", "no limit", false, true},
     of_heat<&Thermal::contact_temperature_limit>()},
    {{P::conductance_stator_contact, "conductance_stator_contact", "", "W/K",
      "thermal.conductances.stator_contact", 1e-12, 1e9, false, false, kNoAlternative, "15 W/K",
      "thermal conductance from the stator through its teeth to the contact",
      "1 pW/K transmits practically no heat; at 1 GW/K both sides have one temperature",
      "the geometry's; the model with three masses needs it", false},
     of_heat<&Thermal::conductances, &ThermalConductances::stator_contact>()
         .read_by(stator_contact_conductance)
         .used_if(is_there<&Thermal::conductances, &ThermalConductances::stator_contact>)},
    {{P::conductance_lining, "conductance_lining", "", "W/K", "thermal.conductances.lining", 1e-12,
      1e9, false, false, kNoAlternative, "0.333 W/K",
      "thermal conductance from the contact through the lining to the rotor",
      "1 pW/K transmits practically no heat; at 1 GW/K both sides have one temperature",
      "conductivity 2 pi r b / h", false},
     of_heat<&Thermal::conductances, &ThermalConductances::lining>()
         .read_by(lining_conductance)
         .used_if(is_there<&Thermal::conductances, &ThermalConductances::lining>)},
    {{P::conductance_stator_housing, "conductance_stator_housing", "", "W/K",
      "thermal.conductances.stator_housing", 0, 1e9, false, false, kNoAlternative, "0.8 W/K",
      "thermal conductance from the stator through the web to the housing",
      "0 is no path; at 1 GW/K both sides have one temperature",
      "the geometry's; the model with three masses needs it", false},
     of_heat<&Thermal::conductances, &ThermalConductances::stator_housing>()
         .read_by(stator_housing_conductance)
         .used_if(is_there<&Thermal::conductances, &ThermalConductances::stator_housing>)},
    {{P::conductance_rotor_housing, "conductance_rotor_housing", "", "W/K",
      "thermal.conductances.rotor_housing", 0, 1e9, false, false, kNoAlternative, "0.25 W/K",
      "thermal conductance from the rotor through bearing and shaft to the housing",
      "0 is no path; at 1 GW/K both sides have one temperature",
      "none; the model with three masses needs it", false},
     of_heat<&Thermal::conductances, &ThermalConductances::rotor_housing>()},
    {{P::conductance_housing_ambient, "conductance_housing_ambient", "", "W/K",
      "thermal.conductances.housing_ambient", 0, 1e9, false, false, kNoAlternative, "0.22 W/K",
      "thermal conductance from the housing through flange and air to the ambient",
      "0 is no path; at 1 GW/K both sides have one temperature", "0 W/K", false},
     of_heat<&Thermal::conductances, &ThermalConductances::housing_ambient>()},
    {{P::conductance_stator_ambient, "conductance_stator_ambient", "", "W/K",
      "thermal.conductances.stator_ambient", 0, 1e9, false, false, kNoAlternative, "0.03 W/K",
      "thermal conductance from the stator to the ambient",
      "0 is no path; at 1 GW/K both sides have one temperature", "0 W/K", false},
     of_heat<&Thermal::conductances, &ThermalConductances::stator_ambient>()},
    {{P::conductance_rotor_ambient, "conductance_rotor_ambient", "", "W/K",
      "thermal.conductances.rotor_ambient", 0, 1e9, false, false, kNoAlternative, "0.03 W/K",
      "thermal conductance from the rotor to the ambient",
      "0 is no path; at 1 GW/K both sides have one temperature", "0 W/K", false},
     of_heat<&Thermal::conductances, &ThermalConductances::rotor_ambient>()},
    {{P::drift_resonance_frequency, "drift_resonance_frequency", "", "1/K",
      "thermal.drift.resonance_frequency", -0.1, 0.1, false, false, kNoAlternative, "-0.022 %/K",
      "relative change of resonance_frequency per kelvin",
      "at 10 %/K no linear law holds over ten kelvin", "0 1/K", false},
     of_heat<&Thermal::drift, &ThermalDrift::resonance_frequency>()},
    {{P::drift_quality_factor, "drift_quality_factor", "", "1/K", "thermal.drift.quality_factor",
      -0.1, 0.1, false, false, kNoAlternative, "-0.3 %/K",
      "relative change of quality_factor per kelvin",
      "at 10 %/K no linear law holds over ten kelvin", "0 1/K", false},
     of_heat<&Thermal::drift, &ThermalDrift::quality_factor>()},
    {{P::drift_modal_damping, "drift_modal_damping", "", "1/K", "thermal.drift.modal_damping", -0.1,
      0.1, false, false, kNoAlternative, "0.3 %/K", "relative change of modal_damping per kelvin",
      "at 10 %/K no linear law holds over ten kelvin", "0 1/K", false},
     of_heat<&Thermal::drift, &ThermalDrift::modal_damping>()},
    {{P::drift_force_factor, "drift_force_factor", "", "1/K", "thermal.drift.force_factor", -0.1,
      0.1, false, false, kNoAlternative, "0.05 %/K", "relative change of force_factor per kelvin",
      "at 10 %/K no linear law holds over ten kelvin", "0 1/K", false},
     of_heat<&Thermal::drift, &ThermalDrift::force_factor>()},
    {{P::drift_blocked_capacitance, "drift_blocked_capacitance", "", "1/K",
      "thermal.drift.blocked_capacitance", -0.1, 0.1, false, false, kNoAlternative, "0.4 %/K",
      "relative change of blocked_capacitance per kelvin",
      "at 10 %/K no linear law holds over ten kelvin", "0 1/K", false},
     of_heat<&Thermal::drift, &ThermalDrift::blocked_capacitance>()},
    {{P::drift_loss_tangent, "drift_loss_tangent", "", "1/K", "thermal.drift.loss_tangent", -0.1,
      0.1, false, false, kNoAlternative, "0.5 %/K", "relative change of loss_tangent per kelvin",
      "at 10 %/K no linear law holds over ten kelvin", "0 1/K", false},
     of_heat<&Thermal::drift, &ThermalDrift::loss_tangent>()},
    {{P::drift_youngs_modulus, "drift_youngs_modulus", "", "1/K", "thermal.drift.youngs_modulus",
      -0.1, 0.1, false, false, kNoAlternative, "-0.3 %/K",
      "relative change of youngs_modulus and of the shear modulus per kelvin",
      "at 10 %/K no linear law holds over ten kelvin", "0 1/K", false},
     of_heat<&Thermal::drift, &ThermalDrift::youngs_modulus>()},
    {{P::drift_loss_factor, "drift_loss_factor", "", "1/K", "thermal.drift.loss_factor", -0.1, 0.1,
      false, false, kNoAlternative, "0.2 %/K", "relative change of loss_factor per kelvin",
      "at 10 %/K no linear law holds over ten kelvin", "0 1/K", false},
     of_heat<&Thermal::drift, &ThermalDrift::loss_factor>()},
    {{P::drift_shear_viscosity, "drift_shear_viscosity", "", "1/K", "thermal.drift.shear_viscosity",
      -0.1, 0.1, false, false, kNoAlternative, "-0.2 %/K",
      "relative change of shear_viscosity per kelvin",
      "at 10 %/K no linear law holds over ten kelvin", "0 1/K", false},
     of_heat<&Thermal::drift, &ThermalDrift::shear_viscosity>()},
    {{P::drift_kinetic_friction, "drift_kinetic_friction", "", "1/K",
      "thermal.drift.kinetic_friction", -0.1, 0.1, false, false, kNoAlternative, "-0.1 %/K",
      "relative change of kinetic_friction and of static_friction per kelvin",
      "at 10 %/K no linear law holds over ten kelvin", "0 1/K", false},
     of_heat<&Thermal::drift, &ThermalDrift::kinetic_friction>()},
    {{P::drift_specific_wear, "drift_specific_wear", "", "1/K", "thermal.drift.specific_wear", -0.1,
      0.1, false, false, kNoAlternative, "1 %/K",
      "relative change of specific_wear and of stator_specific_wear per kelvin",
      "at 10 %/K no linear law holds over ten kelvin", "0 1/K", false},
     of_heat<&Thermal::drift, &ThermalDrift::specific_wear>()},
    {{P::one_node_rise, "one_node_rise", "", "K", "thermal.one_node.rise", 1e-6, 3000, false, false,
      kNoAlternative, "40 K", "steady rise above ambient at one_node_torque",
      "from the resolution of good thermometers to beyond any ceramic",
      "none; the model with one node needs it", false},
     of_heat<&Thermal::one_node, &OneNode::rise>()},
    {{P::one_node_torque, "one_node_torque", "", "N.m", "thermal.one_node.at", 0, 1e12, false,
      false, kNoAlternative, "0.5 N.m", "load torque of one_node_rise",
      "0 is no load; 1 TN.m is friction of 100 GN at 1 m", "0 N.m", false},
     of_heat<&Thermal::one_node, &OneNode::torque>()},
    {{P::one_node_time_constant, "one_node_time_constant", "", "s",
      "thermal.one_node.time_constant", 1e-9, 1.08e9, false, false, kNoAlternative, "11 min",
      "time constant of the warm-up", "from a silicon disc of 10 um to 34 years",
      "none; the model with one node needs it", false},
     of_heat<&Thermal::one_node, &OneNode::time_constant>()},
})};

}  // namespace thermal_rows

using thermal_rows::kThermalRows;
}  // namespace twum::inline v0_1
