// SPDX-License-Identifier: Apache-2.0
#include "design/stator_heat.hpp"

#include <twum/base/no_value.hpp>

#include <algorithm>

namespace twum {
namespace {

// Whether a number of the network may follow: of three masses, and not given.
bool is_open(const MotorDesign& design, const std::optional<double>& given) {
  return design.thermal && !design.thermal->one_node && design.stator.geometry && !given;
}

ParameterArray<double> values_of(const MotorDesign& design) {
  ParameterArray<double> values{};
  for (std::size_t i = index_of(Parameter::substrate_inner_radius); i < kParameterCount; ++i)
    values[i] = get(design, static_cast<Parameter>(i));
  for (const Parameter p :
       {Parameter::contact_radius, Parameter::contact_width, Parameter::substrate_conductivity,
        Parameter::substrate_specific_heat, Parameter::ceramic_specific_heat})
    values[index_of(p)] = get(design, p);
  return values;
}

}  // namespace

bool web_conducts(const MotorDesign& design) {
  if (!design.thermal || !is_open(design, design.thermal->conductances.stator_housing))
    return false;
  const stator::StatorGeometry& g = *design.stator.geometry;
  return g.web && g.substrate.conductivity && g.support == stator::InnerEdge::clamped;
}

bool teeth_conduct(const MotorDesign& design) {
  if (!design.thermal || !is_open(design, design.thermal->conductances.stator_contact))
    return false;
  const stator::StatorGeometry& g = *design.stator.geometry;
  return g.teeth && g.substrate.conductivity;
}

bool stator_stores(const MotorDesign& design) {
  if (!design.thermal || !is_open(design, design.thermal->stator.heat_capacity)) return false;
  const stator::StatorGeometry& g = *design.stator.geometry;
  return g.substrate.specific_heat && g.ceramic.specific_heat;
}

std::pair<Parameter, Parameter> web_in_plate(const MotorDesign& design) {
  using P = Parameter;
  const stator::StatorGeometry& g = *design.stator.geometry;
  const P from = g.web->inner_radius > g.substrate.inner_radius ? P::web_inner_radius
                                                                : P::substrate_inner_radius,
          to = g.web->outer_radius < g.substrate.outer_radius ? P::web_outer_radius
                                                              : P::substrate_outer_radius;
  return get(design, from) < get(design, to) ? std::pair(from, to) : std::pair(from, from);
}

double stator_housing_conductance(const MotorDesign& design) {
  if (web_conducts(design)) return web_conductance_of(values_of(design));
  return design.thermal ? design.thermal->conductances.stator_housing.value_or(kNoValue) : kNoValue;
}

double stator_contact_conductance(const MotorDesign& design) {
  if (teeth_conduct(design)) return teeth_conductance_of(values_of(design));
  return design.thermal ? design.thermal->conductances.stator_contact.value_or(kNoValue) : kNoValue;
}

double stator_heat_capacity(const MotorDesign& design) {
  if (stator_stores(design)) return stator_heat_capacity_of(design, values_of(design));
  return design.thermal ? design.thermal->stator.heat_capacity.value_or(kNoValue) : kNoValue;
}

}  // namespace twum
