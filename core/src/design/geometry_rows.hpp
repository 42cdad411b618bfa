// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "design/motor_rows.hpp"

#include <twum/stator/geometry.hpp>

#include <array>

namespace twum::inline v0_1 {
namespace geometry_rows {

using P = Parameter;
using D = stator::Dimension;

/// A row for a number of the stator's geometry. Without a fallback it is needed if its block is given.
constexpr ParameterRow geometry_row(Parameter parameter, std::string_view name,
                                    std::string_view entry, std::string_view unit, double min,
                                    double max, std::string_view fallback, std::string_view example,
                                    std::string_view text, std::string_view reason,
                                    const ParameterPlace& place) {
  const bool whole = parameter == P::teeth_count, needed = fallback.empty();
  return {{parameter,
           name,
           "",
           unit,
           entry,
           min,
           max,
           whole,
           needed,
           {},
           example,
           text,
           reason,
           fallback},
          place};
}

/// The member for a dimension; null without its block.
template <D dimension, typename Design>
auto* held(Design& design) {
  auto& geometry = design.stator.geometry;
  return geometry ? stator::find(*geometry, dimension) : nullptr;
}

template <D dimension>
constexpr ParameterPlace of_geometry() {
  return ParameterPlace{[](const MotorDesign& d) {
                          const double* number = held<dimension>(d);
                          return number ? *number : kNoValue;
                        },
                        nullptr,
                        [](MotorDesign& d, double value) {
                          double* number = held<dimension>(d);
                          if (number) *number = value;
                          return number != nullptr;
                        }}
      .moving(dimension);
}

/// A radius of the electrodes; that of the ceramic if it is left out.
template <D dimension, auto member, auto ceramic>
constexpr ParameterPlace of_electrodes() {
  return of_geometry<dimension>()
      .used_if([](const MotorDesign& d) { return held<dimension>(d) != nullptr; })
      .read_by([](const MotorDesign& d) {
        const auto& geometry = d.stator.geometry;
        return geometry ? (geometry->electrodes.*member).value_or(geometry->ceramic.*ceramic)
                        : kNoValue;
      })
      .set_by([](MotorDesign& d, double value) {
        if (d.stator.geometry) d.stator.geometry->electrodes.*member = value;
        return d.stator.geometry.has_value();
      });
}

inline constexpr ParameterPlace kTeethCount{
    [](const MotorDesign& d) {
      const auto& geometry = d.stator.geometry;
      return geometry && geometry->teeth ? double(geometry->teeth->count) : kNoValue;
    },
    [](const MotorDesign& d) { return d.stator.geometry && d.stator.geometry->teeth; },
    [](MotorDesign& d, double value) {
      if (!d.stator.geometry || !d.stator.geometry->teeth) return false;
      d.stator.geometry->teeth->count = static_cast<int>(value);
      return true;
    }};

inline constexpr ParameterPlace kWavesPerPhase{
    [](const MotorDesign& d) {
      return d.stator.geometry ? d.stator.geometry->electrodes.waves_per_phase : kNoValue;
    },
    [](const MotorDesign& d) { return d.stator.geometry.has_value(); },
    [](MotorDesign& d, double value) {
      if (d.stator.geometry) d.stator.geometry->electrodes.waves_per_phase = value;
      return d.stator.geometry.has_value();
    }};

/// Without thickness nothing depends on the glue.
inline bool has_glue(const MotorDesign& d) {
  return d.stator.geometry && d.stator.geometry->glue.thickness != 0;
}

inline constexpr std::string_view kRadiusReason = "from silicon discs to rings of 4 m";
inline constexpr std::string_view kThicknessReason = "from films of 10 nm to plates of 1 m";
inline constexpr std::string_view kModulusReason =
    "from soft polymers, 1 MPa, to ten times diamond";
inline constexpr std::string_view kPoissonReason =
    "a stable isotropic material lies between -1 and 0.5";
inline constexpr std::string_view kDensityReason = "from aerogels to osmium, 22600 kg/m^3";
inline constexpr std::string_view kNeeded;

/// Rows of the parameter table for the stator's geometry.
inline constexpr std::array kGeometryRows{
    geometry_row(P::substrate_inner_radius, "substrate_inner_radius",
                 "stator.geometry.substrate.inner_radius", "m", 1e-4, 2, kNeeded, "21.5 mm",
                 "inner radius of the metal plate", kRadiusReason,
                 of_geometry<D::substrate_inner_radius>()),
    geometry_row(P::substrate_outer_radius, "substrate_outer_radius",
                 "stator.geometry.substrate.outer_radius", "m", 1e-4, 2, kNeeded, "30 mm",
                 "outer radius of the metal plate", kRadiusReason,
                 of_geometry<D::substrate_outer_radius>()),
    geometry_row(P::substrate_thickness, "substrate_thickness",
                 "stator.geometry.substrate.thickness", "m", 1e-8, 1, kNeeded, "2.4 mm",
                 "thickness of the metal plate without teeth", kThicknessReason,
                 of_geometry<D::substrate_thickness>()),
    geometry_row(P::substrate_youngs_modulus, "substrate_youngs_modulus",
                 "stator.geometry.substrate.youngs_modulus", "Pa", 1e6, 1e13, kNeeded, "110 GPa",
                 "Young's modulus of the metal", kModulusReason,
                 of_geometry<D::substrate_youngs_modulus>()),
    geometry_row(P::substrate_poisson_ratio, "substrate_poisson_ratio",
                 "stator.geometry.substrate.poisson_ratio", "1", -0.99, 0.5, kNeeded, "0.34",
                 "Poisson ratio of the metal", kPoissonReason,
                 of_geometry<D::substrate_poisson_ratio>()),
    geometry_row(P::substrate_density, "substrate_density", "stator.geometry.substrate.density",
                 "kg/m^3", 1, 3e4, kNeeded, "8800 kg/m^3", "density of the metal", kDensityReason,
                 of_geometry<D::substrate_density>()),
    geometry_row(P::web_inner_radius, "web_inner_radius", "stator.geometry.web.inner_radius", "m",
                 1e-4, 2, kNeeded, "12.5 mm", "inner radius of the web", kRadiusReason,
                 of_geometry<D::web_inner_radius>()),
    geometry_row(P::web_outer_radius, "web_outer_radius", "stator.geometry.web.outer_radius", "m",
                 1e-4, 2, kNeeded, "21.5 mm", "outer radius of the web, where the ring begins",
                 kRadiusReason, of_geometry<D::web_outer_radius>()),
    geometry_row(P::web_thickness, "web_thickness", "stator.geometry.web.thickness", "m", 1e-8, 1,
                 kNeeded, "1 mm", "thickness of the web", kThicknessReason,
                 of_geometry<D::web_thickness>()),
    geometry_row(P::teeth_count, "teeth_count", "stator.geometry.teeth.count", "1", 1, 10000,
                 kNeeded, "90", "number of teeth",
                 "1 is a ring with one slot; more than 10000 would be narrower than 0.1 mm on a "
                 "ring of 300 mm",
                 kTeethCount),
    geometry_row(P::teeth_height, "teeth_height", "stator.geometry.teeth.height", "m", 1e-8, 1,
                 kNeeded, "1.6 mm", "height of the teeth on the metal plate", kThicknessReason,
                 of_geometry<D::teeth_height>()),
    geometry_row(P::teeth_slot_width, "teeth_slot_width", "stator.geometry.teeth.slot_width", "m",
                 0, 1, kNeeded, "0.6 mm", "width of the slots between the teeth",
                 "0 is a ring without slots", of_geometry<D::teeth_slot_width>()),
    geometry_row(P::teeth_inner_radius, "teeth_inner_radius", "stator.geometry.teeth.inner_radius",
                 "m", 1e-4, 2, kNeeded, "23 mm", "inner radius of the teeth", kRadiusReason,
                 of_geometry<D::teeth_inner_radius>()),
    geometry_row(P::teeth_outer_radius, "teeth_outer_radius", "stator.geometry.teeth.outer_radius",
                 "m", 1e-4, 2, kNeeded, "30 mm", "outer radius of the teeth", kRadiusReason,
                 of_geometry<D::teeth_outer_radius>()),
    geometry_row(
        P::teeth_stiffness_share, "teeth_stiffness_share", "stator.geometry.teeth.stiffness_share",
        "1", 0, 1, "0.1", "0.1", "bending stiffness of the layer of teeth over that of solid metal",
        "0 for separate teeth; 1 for metal without slots", of_geometry<D::teeth_stiffness_share>()),
    geometry_row(P::glue_thickness, "glue_thickness", "stator.geometry.glue.thickness", "m", 0, 0.1,
                 "0 m", "20 um", "thickness of the glue between metal and ceramic",
                 "0 is a stator without glue", of_geometry<D::glue_thickness>()),
    geometry_row(P::glue_youngs_modulus, "glue_youngs_modulus",
                 "stator.geometry.glue.youngs_modulus", "Pa", 1e6, 1e13, "4 GPa", "4 GPa",
                 "Young's modulus of the glue", kModulusReason,
                 of_geometry<D::glue_youngs_modulus>().used_if(has_glue)),
    geometry_row(P::glue_poisson_ratio, "glue_poisson_ratio", "stator.geometry.glue.poisson_ratio",
                 "1", -0.99, 0.5, "0.35", "0.35", "Poisson ratio of the glue", kPoissonReason,
                 of_geometry<D::glue_poisson_ratio>().used_if(has_glue)),
    geometry_row(P::glue_density, "glue_density", "stator.geometry.glue.density", "kg/m^3", 1, 3e4,
                 "1200 kg/m^3", "1200 kg/m^3", "density of the glue", kDensityReason,
                 of_geometry<D::glue_density>().used_if(has_glue)),
    geometry_row(P::ceramic_inner_radius, "ceramic_inner_radius",
                 "stator.geometry.ceramic.inner_radius", "m", 1e-4, 2, kNeeded, "22 mm",
                 "inner radius of the piezoceramic", kRadiusReason,
                 of_geometry<D::ceramic_inner_radius>()),
    geometry_row(P::ceramic_outer_radius, "ceramic_outer_radius",
                 "stator.geometry.ceramic.outer_radius", "m", 1e-4, 2, kNeeded, "30 mm",
                 "outer radius of the piezoceramic", kRadiusReason,
                 of_geometry<D::ceramic_outer_radius>()),
    geometry_row(P::ceramic_thickness, "ceramic_thickness", "stator.geometry.ceramic.thickness",
                 "m", 1e-8, 1, kNeeded, "0.5 mm", "thickness of the piezoceramic", kThicknessReason,
                 of_geometry<D::ceramic_thickness>()),
    geometry_row(P::ceramic_youngs_modulus, "ceramic_youngs_modulus",
                 "stator.geometry.ceramic.youngs_modulus", "Pa", 1e6, 1e13, kNeeded, "80 GPa",
                 "Young's modulus of the piezoceramic, short-circuited", kModulusReason,
                 of_geometry<D::ceramic_youngs_modulus>()),
    geometry_row(P::ceramic_poisson_ratio, "ceramic_poisson_ratio",
                 "stator.geometry.ceramic.poisson_ratio", "1", -0.99, 0.5, kNeeded, "0.31",
                 "Poisson ratio of the piezoceramic", kPoissonReason,
                 of_geometry<D::ceramic_poisson_ratio>()),
    geometry_row(P::ceramic_density, "ceramic_density", "stator.geometry.ceramic.density", "kg/m^3",
                 1, 3e4, kNeeded, "7600 kg/m^3", "density of the piezoceramic", kDensityReason,
                 of_geometry<D::ceramic_density>()),
    geometry_row(P::ceramic_d31, "ceramic_d31", "stator.geometry.ceramic.d31", "m/V", -1e-8, 1e-8,
                 kNeeded, "-125 pm/V",
                 "piezoelectric coefficient of the piezoceramic, usually negative",
                 "single crystals have -2 nm/V", of_geometry<D::ceramic_d31>()),
    geometry_row(P::ceramic_permittivity, "ceramic_permittivity",
                 "stator.geometry.ceramic.permittivity", "F/m", 1e-12, 1e-5, kNeeded, "11.3 nF/m",
                 "permittivity of the piezoceramic at constant stress",
                 "from less than that of the vacuum to a hundred times the largest of ceramics",
                 of_geometry<D::ceramic_permittivity>()),
    geometry_row(P::electrodes_waves_per_phase, "electrodes_waves_per_phase",
                 "stator.geometry.electrodes.waves_per_phase", "1", 0.01, 100, kNeeded, "4",
                 "number of wavelengths that the electrodes of a phase cover",
                 "from a hundredth of a wavelength to half of the largest number of wavelengths",
                 kWavesPerPhase),
    geometry_row(P::electrodes_inner_radius, "electrodes_inner_radius",
                 "stator.geometry.electrodes.inner_radius", "m", 1e-4, 2, "the ceramic's", "22 mm",
                 "inner radius of the electrodes", kRadiusReason,
                 of_electrodes<D::electrodes_inner_radius, &stator::Electrodes::inner_radius,
                               &stator::Ceramic::inner_radius>()),
    geometry_row(P::electrodes_outer_radius, "electrodes_outer_radius",
                 "stator.geometry.electrodes.outer_radius", "m", 1e-4, 2, "the ceramic's", "30 mm",
                 "outer radius of the electrodes", kRadiusReason,
                 of_electrodes<D::electrodes_outer_radius, &stator::Electrodes::outer_radius,
                               &stator::Ceramic::outer_radius>()),
};

}  // namespace geometry_rows

using geometry_rows::kGeometryRows;
}  // namespace twum::inline v0_1
