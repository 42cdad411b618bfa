// SPDX-License-Identifier: Apache-2.0
#include <twum/stator/geometry.hpp>

namespace twum::stator {

const std::array<DimensionInfo, kDimensions>& dimension_table() {
  static constexpr std::array<DimensionInfo, kDimensions> table{{
      {"substrate_inner_radius", "m"},  {"substrate_outer_radius", "m"},
      {"substrate_thickness", "m"},     {"substrate_youngs_modulus", "Pa"},
      {"substrate_poisson_ratio", "1"}, {"substrate_density", "kg/m^3"},
      {"web_inner_radius", "m"},        {"web_outer_radius", "m"},
      {"web_thickness", "m"},           {"teeth_height", "m"},
      {"teeth_slot_width", "m"},        {"teeth_inner_radius", "m"},
      {"teeth_outer_radius", "m"},      {"teeth_stiffness_share", "1"},
      {"glue_thickness", "m"},          {"glue_youngs_modulus", "Pa"},
      {"glue_poisson_ratio", "1"},      {"glue_density", "kg/m^3"},
      {"ceramic_inner_radius", "m"},    {"ceramic_outer_radius", "m"},
      {"ceramic_thickness", "m"},       {"ceramic_youngs_modulus", "Pa"},
      {"ceramic_poisson_ratio", "1"},   {"ceramic_density", "kg/m^3"},
      {"ceramic_d31", "m/V"},           {"ceramic_permittivity", "F/m"},
      {"electrodes_inner_radius", "m"}, {"electrodes_outer_radius", "m"},
      {"contact_radius", "m"},
  }};
  return table;
}

namespace {

template <typename Block, typename Member>
double* member(std::optional<Block>& block, Member name) {
  return block ? &((*block).*name) : nullptr;
}

double* value(std::optional<double>& number) { return number ? &*number : nullptr; }

}  // namespace

double* find(StatorGeometry& g, Dimension dimension) {
  switch (dimension) {
    case Dimension::substrate_inner_radius: return &g.substrate.inner_radius;
    case Dimension::substrate_outer_radius: return &g.substrate.outer_radius;
    case Dimension::substrate_thickness: return &g.substrate.thickness;
    case Dimension::substrate_youngs_modulus: return &g.substrate.youngs_modulus;
    case Dimension::substrate_poisson_ratio: return &g.substrate.poisson_ratio;
    case Dimension::substrate_density: return &g.substrate.density;
    case Dimension::web_inner_radius: return member(g.web, &Web::inner_radius);
    case Dimension::web_outer_radius: return member(g.web, &Web::outer_radius);
    case Dimension::web_thickness: return member(g.web, &Web::thickness);
    case Dimension::teeth_height: return member(g.teeth, &Teeth::height);
    case Dimension::teeth_slot_width: return member(g.teeth, &Teeth::slot_width);
    case Dimension::teeth_inner_radius: return member(g.teeth, &Teeth::inner_radius);
    case Dimension::teeth_outer_radius: return member(g.teeth, &Teeth::outer_radius);
    case Dimension::teeth_stiffness_share: return member(g.teeth, &Teeth::stiffness_share);
    case Dimension::glue_thickness: return &g.glue.thickness;
    case Dimension::glue_youngs_modulus: return &g.glue.youngs_modulus;
    case Dimension::glue_poisson_ratio: return &g.glue.poisson_ratio;
    case Dimension::glue_density: return &g.glue.density;
    case Dimension::ceramic_inner_radius: return &g.ceramic.inner_radius;
    case Dimension::ceramic_outer_radius: return &g.ceramic.outer_radius;
    case Dimension::ceramic_thickness: return &g.ceramic.thickness;
    case Dimension::ceramic_youngs_modulus: return &g.ceramic.youngs_modulus;
    case Dimension::ceramic_poisson_ratio: return &g.ceramic.poisson_ratio;
    case Dimension::ceramic_density: return &g.ceramic.density;
    case Dimension::ceramic_d31: return &g.ceramic.d31;
    case Dimension::ceramic_permittivity: return &g.ceramic.permittivity;
    case Dimension::electrodes_inner_radius: return value(g.electrodes.inner_radius);
    case Dimension::electrodes_outer_radius: return value(g.electrodes.outer_radius);
    case Dimension::contact_radius: return nullptr;
  }
  return nullptr;
}

const double* find(const StatorGeometry& geometry, Dimension dimension) {
  return find(const_cast<StatorGeometry&>(geometry), dimension);
}

}  // namespace twum::stator
