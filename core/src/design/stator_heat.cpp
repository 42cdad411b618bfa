// SPDX-License-Identifier: Apache-2.0
#include "design/stator_heat.hpp"

#include <twum/base/no_value.hpp>

#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace twum::inline v0_1 {
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
  const double r = design.stator.contact_radius, b = design.stator.contact_width;
  return g.teeth && g.substrate.conductivity && g.teeth->inner_radius <= r - b / 2 &&
         g.teeth->outer_radius >= r + b / 2;  // under the whole track
}

bool stator_stores(const MotorDesign& design) {
  if (!design.thermal || !is_open(design, design.thermal->stator.heat_capacity)) return false;
  const stator::StatorGeometry& g = *design.stator.geometry;
  return g.substrate.specific_heat && g.ceramic.specific_heat;
}

// The radii between which the web takes the place of the plate; the same radius twice if it does not.
std::pair<Parameter, Parameter> web_in_plate(const MotorDesign& design) {
  using P = Parameter;
  const stator::StatorGeometry& g = *design.stator.geometry;
  const P from = g.web->inner_radius > g.substrate.inner_radius ? P::web_inner_radius
                                                                : P::substrate_inner_radius,
          to = g.web->outer_radius < g.substrate.outer_radius ? P::web_outer_radius
                                                              : P::substrate_outer_radius;
  return get(design, from) < get(design, to) ? std::pair(from, to) : std::pair(from, from);
}

// Specific heat of the glue, an epoxy; it is some thousandth of the stator's [J/(kg K)].
constexpr double kGlueSpecificHeat = 1100;

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

}  // namespace

void add_stator_heat(const MotorDesign& given, ParameterArray<Dual<double, 1>>& p) {
  if (web_conducts(given))
    p[index_of(Parameter::conductance_stator_housing)] = web_conductance_of(p);
  if (teeth_conduct(given))
    p[index_of(Parameter::conductance_stator_contact)] = teeth_conductance_of(p);
  if (stator_stores(given))
    p[index_of(Parameter::stator_heat_capacity)] = stator_heat_capacity_of(given, p);
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

}  // namespace twum::inline v0_1
