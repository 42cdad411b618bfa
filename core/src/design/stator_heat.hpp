// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "design/layer_properties.hpp"

#include <twum/core/parameters.hpp>

#include <cmath>
#include <numbers>
#include <utility>

namespace twum {

/// @name Numbers of the thermal network that follow from the stator's geometry and materials where the motor does not give them
/// @{

/// Through the web, whose inner edge is clamped, to the housing.
bool web_conducts(const MotorDesign& design);
/// Through the teeth to the contact.
bool teeth_conduct(const MotorDesign& design);
/// Of metal, glue and ceramic.
bool stator_stores(const MotorDesign& design);

double stator_housing_conductance(const MotorDesign& design);
double stator_contact_conductance(const MotorDesign& design);
double stator_heat_capacity(const MotorDesign& design);
/// @}

/// The radii between which the web takes the place of the plate; the same radius twice if it does not.
std::pair<Parameter, Parameter> web_in_plate(const MotorDesign& design);

/// Specific heat of the glue, an epoxy; it is some thousandth of the stator's [J/(kg K)].
inline constexpr double kGlueSpecificHeat = 1100;

/// The parts of with_alternatives() about these numbers.
/// @{
template <typename S>
S web_conductance_of(const ParameterArray<S>& p) {  // (H1.7)
  using std::log;
  using P = Parameter;
  const auto at = [&p](P parameter) -> const S& { return p[index_of(parameter)]; };
  return 2 * std::numbers::pi * at(P::substrate_conductivity) * at(P::web_thickness) /
         log(at(P::web_outer_radius) / at(P::web_inner_radius));
}

template <typename S>
S teeth_conductance_of(const ParameterArray<S>& p) {  // (H1.8)
  using P = Parameter;
  const auto at = [&p](P parameter) -> const S& { return p[index_of(parameter)]; };
  const S length =
      2 * std::numbers::pi * at(P::contact_radius) - at(P::teeth_count) * at(P::teeth_slot_width);
  return at(P::substrate_conductivity) * length * at(P::contact_width) / at(P::teeth_height);
}

template <typename S>
S stator_heat_capacity_of(const MotorDesign& given, const ParameterArray<S>& p) {  // (H1.9)
  using P = Parameter;
  const auto at = [&p](P parameter) -> const S& { return p[index_of(parameter)]; };
  const auto ring = [&](P inner, P outer) -> S {
    return std::numbers::pi * (at(outer) * at(outer) - at(inner) * at(inner));
  };
  const S plate = ring(P::substrate_inner_radius, P::substrate_outer_radius);
  const S ceramic = ring(P::ceramic_inner_radius, P::ceramic_outer_radius);
  S metal = plate * at(P::substrate_thickness);
  if (given.stator.geometry->web) {
    metal = metal + ring(P::web_inner_radius, P::web_outer_radius) * at(P::web_thickness);
    const auto& [from, to] = web_in_plate(given);
    if (from != to) metal = metal - ring(from, to) * at(P::substrate_thickness);
  }
  if (given.stator.geometry->teeth)
    metal = metal + (ring(P::teeth_inner_radius, P::teeth_outer_radius) -
                     at(P::teeth_count) * at(P::teeth_slot_width) *
                         (at(P::teeth_outer_radius) - at(P::teeth_inner_radius))) *
                        at(P::teeth_height);
  S sum =
      at(P::substrate_specific_heat) * at(P::substrate_density) * metal +
      at(P::ceramic_specific_heat) * at(P::ceramic_density) * ceramic * at(P::ceramic_thickness);
  if (given.stator.geometry->glue.thickness > 0)
    sum = sum + kGlueSpecificHeat * at(P::glue_density) * ceramic * at(P::glue_thickness);
  return sum;
}
/// @}

/// Sets those that follow.
template <typename S>
void add_stator_heat(const MotorDesign& given, ParameterArray<S>& p) {
  if (web_conducts(given))
    p[index_of(Parameter::conductance_stator_housing)] = web_conductance_of(p);
  if (teeth_conduct(given))
    p[index_of(Parameter::conductance_stator_contact)] = teeth_conductance_of(p);
  if (stator_stores(given))
    p[index_of(Parameter::stator_heat_capacity)] = stator_heat_capacity_of(given, p);
}

}  // namespace twum
