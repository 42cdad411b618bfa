// SPDX-License-Identifier: Apache-2.0
#include <twum/stator/geometry.hpp>

#include <algorithm>

namespace twum::inline v0_1::stator {
namespace {

/// One dimension: its name, its unit, and the member of a geometry that holds it, or null.
struct DimensionRow {
  DimensionInfo info;
  double* (*find)(StatorGeometry&);
};

template <auto block, auto member>
double* in(StatorGeometry& g) {
  return &((g.*block).*member);
}

template <auto block, auto member>
double* in_optional(StatorGeometry& g) {
  return g.*block ? &(*(g.*block).*member) : nullptr;
}

template <auto member>
double* given_electrode_radius(StatorGeometry& g) {
  return g.electrodes.*member ? &*(g.electrodes.*member) : nullptr;
}

double* nowhere(StatorGeometry&) { return nullptr; }

constexpr std::array<DimensionRow, kDimensions> kRows{{
    {{"substrate_inner_radius", "m"}, in<&StatorGeometry::substrate, &Substrate::inner_radius>},
    {{"substrate_outer_radius", "m"}, in<&StatorGeometry::substrate, &Substrate::outer_radius>},
    {{"substrate_thickness", "m"}, in<&StatorGeometry::substrate, &Substrate::thickness>},
    {{"substrate_youngs_modulus", "Pa"},
     in<&StatorGeometry::substrate, &Substrate::youngs_modulus>},
    {{"substrate_poisson_ratio", "1"}, in<&StatorGeometry::substrate, &Substrate::poisson_ratio>},
    {{"substrate_density", "kg/m^3"}, in<&StatorGeometry::substrate, &Substrate::density>},
    {{"web_inner_radius", "m"}, in_optional<&StatorGeometry::web, &Web::inner_radius>},
    {{"web_outer_radius", "m"}, in_optional<&StatorGeometry::web, &Web::outer_radius>},
    {{"web_thickness", "m"}, in_optional<&StatorGeometry::web, &Web::thickness>},
    {{"teeth_height", "m"}, in_optional<&StatorGeometry::teeth, &Teeth::height>},
    {{"teeth_slot_width", "m"}, in_optional<&StatorGeometry::teeth, &Teeth::slot_width>},
    {{"teeth_inner_radius", "m"}, in_optional<&StatorGeometry::teeth, &Teeth::inner_radius>},
    {{"teeth_outer_radius", "m"}, in_optional<&StatorGeometry::teeth, &Teeth::outer_radius>},
    {{"teeth_stiffness_share", "1"}, in_optional<&StatorGeometry::teeth, &Teeth::stiffness_share>},
    {{"glue_thickness", "m"}, in<&StatorGeometry::glue, &Glue::thickness>},
    {{"glue_youngs_modulus", "Pa"}, in<&StatorGeometry::glue, &Glue::youngs_modulus>},
    {{"glue_poisson_ratio", "1"}, in<&StatorGeometry::glue, &Glue::poisson_ratio>},
    {{"glue_density", "kg/m^3"}, in<&StatorGeometry::glue, &Glue::density>},
    {{"ceramic_inner_radius", "m"}, in<&StatorGeometry::ceramic, &Ceramic::inner_radius>},
    {{"ceramic_outer_radius", "m"}, in<&StatorGeometry::ceramic, &Ceramic::outer_radius>},
    {{"ceramic_thickness", "m"}, in<&StatorGeometry::ceramic, &Ceramic::thickness>},
    {{"ceramic_youngs_modulus", "Pa"}, in<&StatorGeometry::ceramic, &Ceramic::youngs_modulus>},
    {{"ceramic_poisson_ratio", "1"}, in<&StatorGeometry::ceramic, &Ceramic::poisson_ratio>},
    {{"ceramic_density", "kg/m^3"}, in<&StatorGeometry::ceramic, &Ceramic::density>},
    {{"ceramic_d31", "m/V"}, in<&StatorGeometry::ceramic, &Ceramic::d31>},
    {{"ceramic_permittivity", "F/m"}, in<&StatorGeometry::ceramic, &Ceramic::permittivity>},
    {{"electrodes_inner_radius", "m"}, given_electrode_radius<&Electrodes::inner_radius>},
    {{"electrodes_outer_radius", "m"}, given_electrode_radius<&Electrodes::outer_radius>},
    {{"contact_radius", "m"}, nowhere},
}};

}  // namespace

const std::array<DimensionInfo, kDimensions>& dimension_table() {
  static constexpr auto table = [] {
    std::array<DimensionInfo, kDimensions> infos{};
    std::transform(kRows.begin(), kRows.end(), infos.begin(),
                   [](const DimensionRow& row) { return row.info; });
    return infos;
  }();
  return table;
}

double* find(StatorGeometry& geometry, Dimension dimension) {
  return kRows[static_cast<std::size_t>(dimension)].find(geometry);
}

const double* find(const StatorGeometry& geometry, Dimension dimension) {
  return find(const_cast<StatorGeometry&>(geometry), dimension);
}

}  // namespace twum::inline v0_1::stator
