// SPDX-License-Identifier: Apache-2.0
#include "wear/worn_design.hpp"

#include "design/layer_properties.hpp"
#include "design/wear_design.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace twum::inline v0_1::core {
namespace {

using P = Parameter;

// The lining itself conducts: its own thickness counts, not that of the flange beside it (H1.6).
bool conducts_by_material(const MotorDesign& design) {
  return design.thermal && !design.thermal->one_node && !design.thermal->conductances.lining &&
         design.layer.conductivity;
}

double lining_left(const MotorDesign& design, double depth) {
  return design.layer.thickness - lining_part(*design.wear) * depth;
}

}  // namespace

double specific_wear_of_both(const MotorDesign& design) {
  return design.wear->specific_wear.value_or(0) + design.wear->stator_specific_wear;
}

MotorDesign worn_design(const MotorDesign& design, double depth) {
  const std::array<ParameterValue, 2> values{
      {{P::thickness, design.layer.thickness - thickness_share(design) * depth},
       {P::preload, design.preload - design.wear->preload_spring * depth}}};
  MotorDesign worn = with(design, values);
  if (conducts_by_material(worn))
    worn.thermal->conductances.lining =
        lining_conductance_of(*design.layer.conductivity, design.stator.contact_radius,
                              design.stator.contact_width, lining_left(design, depth));
  return worn;
}

HardEnd hard_end(const MotorDesign& design) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const double share = thickness_share(design), spring = design.wear->preload_spring;
  const double through = share > 0 ? design.layer.thickness / share : kNever,
               relaxed = spring > 0 ? design.preload / spring : kNever;
  return {std::fmin(through, relaxed), relaxed < through};
}

WornGradient by_new_motor(const MotorDesign& design, double depth, const WornGradient& of_worn) {
  WornGradient g = of_worn;
  const Wear& wear = *design.wear;
  const double by_h = of_worn[index_of(P::thickness)], by_F = of_worn[index_of(P::preload)];
  const double s = softness(design), chi = lining_part(wear), k = specific_wear_of_both(design);
  if (wear.lining_youngs_modulus) {
    g[index_of(P::youngs_modulus)] -= by_h * chi * depth / *wear.lining_youngs_modulus;
    g[index_of(P::lining_youngs_modulus)] += by_h * s * chi * depth / *wear.lining_youngs_modulus;
  }
  g[index_of(P::specific_wear)] -= by_h * s * depth * (1 - chi) / k;
  g[index_of(P::stator_specific_wear)] += by_h * s * depth * chi / k;
  g[index_of(P::preload_spring)] -= by_F * depth;
  if (!conducts_by_material(design)) return g;
  const double G = get(worn_design(design, depth), P::conductance_lining);
  const double by_G = std::exchange(g[index_of(P::conductance_lining)], 0.0) * G;
  for (const P p : {P::conductivity, P::contact_radius, P::contact_width})
    g[index_of(p)] += by_G / get(design, p);
  const double by_left = -by_G / lining_left(design, depth);
  g[index_of(P::thickness)] += by_left;
  g[index_of(P::specific_wear)] -= by_left * depth * (1 - chi) / k;
  g[index_of(P::stator_specific_wear)] += by_left * depth * chi / k;
  return g;
}

double by_depth(const MotorDesign& design, double depth, const WornGradient& of_worn) {
  double slope = -thickness_share(design) * of_worn[index_of(P::thickness)] -
                 design.wear->preload_spring * of_worn[index_of(P::preload)];
  if (conducts_by_material(design))
    slope += of_worn[index_of(P::conductance_lining)] *
             get(worn_design(design, depth), P::conductance_lining) * lining_part(*design.wear) /
             lining_left(design, depth);
  return slope;
}

}  // namespace twum::inline v0_1::core
