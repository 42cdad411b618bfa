// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/parameters.hpp>

#include <array>

namespace twum {

enum class GeometryNeed : unsigned char { may_lack, in_its_block };

/// A row for a number of the stator's geometry. `needed` means needed if its block is given.
constexpr ParameterInfo geometry_row(Parameter parameter, std::string_view name,
                                     std::string_view entry, std::string_view unit, double min,
                                     double max, GeometryNeed need, std::string_view example,
                                     std::string_view text, std::string_view reason) {
  const bool whole = parameter == Parameter::teeth_count;
  return {
      parameter, name,    "",   unit,  entry, min, max, whole, need == GeometryNeed::in_its_block,
      {},        example, text, reason};
}

inline constexpr std::string_view kRadiusReason = "from silicon discs to rings of 4 m";
inline constexpr std::string_view kThicknessReason = "from films of 10 nm to plates of 1 m";
inline constexpr std::string_view kModulusReason =
    "from soft polymers, 1 MPa, to ten times diamond";
inline constexpr std::string_view kPoissonReason =
    "a stable isotropic material lies between -1 and 0.5";
inline constexpr std::string_view kDensityReason = "from aerogels to osmium, 22600 kg/m^3";
inline constexpr GeometryNeed kNeeded = GeometryNeed::in_its_block,
                              kMayLack = GeometryNeed::may_lack;

/// Rows of the parameter table for the stator's geometry.
inline constexpr std::array<ParameterInfo, 30> kGeometryRows{
    geometry_row(Parameter::substrate_inner_radius, "substrate_inner_radius",
                 "stator.geometry.substrate.inner_radius", "m", 1e-4, 2, kNeeded, "21.5 mm",
                 "inner radius of the metal plate", kRadiusReason),
    geometry_row(Parameter::substrate_outer_radius, "substrate_outer_radius",
                 "stator.geometry.substrate.outer_radius", "m", 1e-4, 2, kNeeded, "30 mm",
                 "outer radius of the metal plate", kRadiusReason),
    geometry_row(Parameter::substrate_thickness, "substrate_thickness",
                 "stator.geometry.substrate.thickness", "m", 1e-8, 1, kNeeded, "2.4 mm",
                 "thickness of the metal plate without teeth", kThicknessReason),
    geometry_row(Parameter::substrate_youngs_modulus, "substrate_youngs_modulus",
                 "stator.geometry.substrate.youngs_modulus", "Pa", 1e6, 1e13, kNeeded, "110 GPa",
                 "Young's modulus of the metal", kModulusReason),
    geometry_row(Parameter::substrate_poisson_ratio, "substrate_poisson_ratio",
                 "stator.geometry.substrate.poisson_ratio", "1", -0.99, 0.5, kNeeded, "0.34",
                 "Poisson ratio of the metal", kPoissonReason),
    geometry_row(Parameter::substrate_density, "substrate_density",
                 "stator.geometry.substrate.density", "kg/m^3", 1, 3e4, kNeeded, "8800 kg/m^3",
                 "density of the metal", kDensityReason),
    geometry_row(Parameter::web_inner_radius, "web_inner_radius",
                 "stator.geometry.web.inner_radius", "m", 1e-4, 2, kNeeded, "12.5 mm",
                 "inner radius of the web", kRadiusReason),
    geometry_row(Parameter::web_outer_radius, "web_outer_radius",
                 "stator.geometry.web.outer_radius", "m", 1e-4, 2, kNeeded, "21.5 mm",
                 "outer radius of the web, where the ring begins", kRadiusReason),
    geometry_row(Parameter::web_thickness, "web_thickness", "stator.geometry.web.thickness", "m",
                 1e-8, 1, kNeeded, "1 mm", "thickness of the web", kThicknessReason),
    geometry_row(Parameter::teeth_count, "teeth_count", "stator.geometry.teeth.count", "1", 1,
                 10000, kNeeded, "90", "number of teeth",
                 "one slot; more would be narrower than 0.1 mm on a ring of 300 mm"),
    geometry_row(Parameter::teeth_height, "teeth_height", "stator.geometry.teeth.height", "m", 1e-8,
                 1, kNeeded, "1.6 mm", "height of the teeth on the metal plate", kThicknessReason),
    geometry_row(Parameter::teeth_slot_width, "teeth_slot_width",
                 "stator.geometry.teeth.slot_width", "m", 0, 1, kNeeded, "0.6 mm",
                 "width of the slots between the teeth", "0 is a ring without slots"),
    geometry_row(Parameter::teeth_inner_radius, "teeth_inner_radius",
                 "stator.geometry.teeth.inner_radius", "m", 1e-4, 2, kNeeded, "23 mm",
                 "inner radius of the teeth", kRadiusReason),
    geometry_row(Parameter::teeth_outer_radius, "teeth_outer_radius",
                 "stator.geometry.teeth.outer_radius", "m", 1e-4, 2, kNeeded, "30 mm",
                 "outer radius of the teeth", kRadiusReason),
    geometry_row(Parameter::teeth_stiffness_share, "teeth_stiffness_share",
                 "stator.geometry.teeth.stiffness_share", "1", 0, 1, kMayLack, "0.1",
                 "bending stiffness of the layer of teeth over that of solid metal",
                 "0 for separate teeth; 1 for metal without slots"),
    geometry_row(Parameter::glue_thickness, "glue_thickness", "stator.geometry.glue.thickness", "m",
                 0, 0.1, kMayLack, "20 um", "thickness of the glue between metal and ceramic",
                 "0 leaves it out"),
    geometry_row(Parameter::glue_youngs_modulus, "glue_youngs_modulus",
                 "stator.geometry.glue.youngs_modulus", "Pa", 1e6, 1e13, kMayLack, "4 GPa",
                 "Young's modulus of the glue", kModulusReason),
    geometry_row(Parameter::glue_poisson_ratio, "glue_poisson_ratio",
                 "stator.geometry.glue.poisson_ratio", "1", -0.99, 0.5, kMayLack, "0.35",
                 "Poisson ratio of the glue", kPoissonReason),
    geometry_row(Parameter::glue_density, "glue_density", "stator.geometry.glue.density", "kg/m^3",
                 1, 3e4, kMayLack, "1200 kg/m^3", "density of the glue", kDensityReason),
    geometry_row(Parameter::ceramic_inner_radius, "ceramic_inner_radius",
                 "stator.geometry.ceramic.inner_radius", "m", 1e-4, 2, kNeeded, "22 mm",
                 "inner radius of the piezoceramic", kRadiusReason),
    geometry_row(Parameter::ceramic_outer_radius, "ceramic_outer_radius",
                 "stator.geometry.ceramic.outer_radius", "m", 1e-4, 2, kNeeded, "30 mm",
                 "outer radius of the piezoceramic", kRadiusReason),
    geometry_row(Parameter::ceramic_thickness, "ceramic_thickness",
                 "stator.geometry.ceramic.thickness", "m", 1e-8, 1, kNeeded, "0.5 mm",
                 "thickness of the piezoceramic", kThicknessReason),
    geometry_row(Parameter::ceramic_youngs_modulus, "ceramic_youngs_modulus",
                 "stator.geometry.ceramic.youngs_modulus", "Pa", 1e6, 1e13, kNeeded, "80 GPa",
                 "Young's modulus of the piezoceramic, short-circuited", kModulusReason),
    geometry_row(Parameter::ceramic_poisson_ratio, "ceramic_poisson_ratio",
                 "stator.geometry.ceramic.poisson_ratio", "1", -0.99, 0.5, kNeeded, "0.31",
                 "Poisson ratio of the piezoceramic", kPoissonReason),
    geometry_row(Parameter::ceramic_density, "ceramic_density", "stator.geometry.ceramic.density",
                 "kg/m^3", 1, 3e4, kNeeded, "7600 kg/m^3", "density of the piezoceramic",
                 kDensityReason),
    geometry_row(Parameter::ceramic_d31, "ceramic_d31", "stator.geometry.ceramic.d31", "m/V", -1e-8,
                 1e-8, kNeeded, "-125 pm/V",
                 "piezoelectric coefficient of the piezoceramic, usually negative",
                 "single crystals have -2 nm/V"),
    geometry_row(Parameter::ceramic_permittivity, "ceramic_permittivity",
                 "stator.geometry.ceramic.permittivity", "F/m", 1e-12, 1e-5, kNeeded, "11.3 nF/m",
                 "permittivity of the piezoceramic at constant stress",
                 "less than that of the vacuum; a hundred times the largest of ceramics"),
    geometry_row(
        Parameter::electrodes_waves_per_phase, "electrodes_waves_per_phase",
        "stator.geometry.electrodes.waves_per_phase", "1", 0.01, 100, kNeeded, "4",
        "wavelengths that the electrodes of a phase cover",
        "from a sector of a hundredth of a wavelength to half of the largest number of waves"),
    geometry_row(Parameter::electrodes_inner_radius, "electrodes_inner_radius",
                 "stator.geometry.electrodes.inner_radius", "m", 1e-4, 2, kMayLack, "22 mm",
                 "inner radius of the electrodes", kRadiusReason),
    geometry_row(Parameter::electrodes_outer_radius, "electrodes_outer_radius",
                 "stator.geometry.electrodes.outer_radius", "m", 1e-4, 2, kMayLack, "30 mm",
                 "outer radius of the electrodes", kRadiusReason),
};

}  // namespace twum
