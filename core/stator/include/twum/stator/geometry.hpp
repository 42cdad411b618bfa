// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/dual.hpp>
#include <twum/stator/plate.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace twum::inline v0_1::stator {

/// The metal plate. Its thickness is that of the ring, without the teeth.
struct Substrate {
  double inner_radius{};                  ///< [m]
  double outer_radius{};                  ///< [m]
  double thickness{};                     ///< [m]
  double youngs_modulus{};                ///< [Pa]
  double poisson_ratio{};                 ///< [1]
  double density{};                       ///< [kg/m^3]
  std::optional<double> conductivity{};   ///< of heat [W/(m K)]
  std::optional<double> specific_heat{};  ///< [J/(kg K)]

  bool operator==(const Substrate&) const = default;  ///< number by number
};

/// A part of the metal plate with a thickness of its own, usually from the clamp to the ring. Where it lies
/// inside the substrate's inner radius it continues the plate inwards.
struct Web {
  double inner_radius{};  ///< [m]
  double outer_radius{};  ///< [m]
  double thickness{};     ///< [m]

  bool operator==(const Web&) const = default;  ///< number by number
};

/// Teeth on top of the metal, cut by radial slots of constant width.
struct Teeth {
  int count{};            ///< [1]
  double height{};        ///< [m]
  double slot_width{};    ///< [m]
  double inner_radius{};  ///< [m]
  double outer_radius{};  ///< [m]
  double stiffness_share{
      0.1};  ///< chi, stiffness of the layer of teeth over that of solid metal [1]

  bool operator==(const Teeth&) const = default;  ///< number by number
};

/// The adhesive between metal and ceramic, as wide as the ceramic. A thickness of 0 leaves it out.
struct Glue {
  double thickness{};          ///< [m]
  double youngs_modulus{4e9};  ///< [Pa]
  double poisson_ratio{0.35};  ///< [1]
  double density{1200};        ///< [kg/m^3]

  bool operator==(const Glue&) const = default;  ///< number by number
};

/// The piezoceramic ring under the metal, polarized along the axis.
struct Ceramic {
  double inner_radius{};                  ///< [m]
  double outer_radius{};                  ///< [m]
  double thickness{};                     ///< h_p [m]
  double youngs_modulus{};                ///< E_p, short-circuited [Pa]
  double poisson_ratio{};                 ///< nu_p [1]
  double density{};                       ///< [kg/m^3]
  double d31{};                           ///< [m/V], usually negative
  double permittivity{};                  ///< eps_33 at constant stress [F/m]
  std::optional<double> specific_heat{};  ///< [J/(kg K)]

  bool operator==(const Ceramic&) const = default;  ///< number by number
};

/// The electrodes of one phase: sectors of half a wavelength, of alternating sign.
struct Electrodes {
  double waves_per_phase{};            ///< N_w, wavelengths that a phase covers [1]
  std::optional<double> inner_radius;  ///< [m]; otherwise the ceramic's
  std::optional<double> outer_radius;  ///< [m]; otherwise the ceramic's

  bool operator==(const Electrodes&) const = default;  ///< number by number
};

/// Geometry and materials of a stator in SI units, without invariants; check_geometry() says whether it can be built.
struct StatorGeometry {
  Substrate substrate;                 ///< the metal
  std::optional<Web> web;              ///< between clamp and ring
  std::optional<Teeth> teeth;          ///< on the ring
  Glue glue;                           ///< between metal and ceramic
  Ceramic ceramic;                     ///< under the metal
  Electrodes electrodes;               ///< of one phase
  InnerEdge support{InnerEdge::free};  ///< of the inner edge

  bool operator==(const StatorGeometry&) const = default;  ///< number by number
};

/// The numbers of a geometry that may vary smoothly, and the contact radius at which the mode is normalized.
enum class Dimension {
  substrate_inner_radius,
  substrate_outer_radius,
  substrate_thickness,
  substrate_youngs_modulus,
  substrate_poisson_ratio,
  substrate_density,
  web_inner_radius,
  web_outer_radius,
  web_thickness,
  teeth_height,
  teeth_slot_width,
  teeth_inner_radius,
  teeth_outer_radius,
  teeth_stiffness_share,
  glue_thickness,
  glue_youngs_modulus,
  glue_poisson_ratio,
  glue_density,
  ceramic_inner_radius,
  ceramic_outer_radius,
  ceramic_thickness,
  ceramic_youngs_modulus,
  ceramic_poisson_ratio,
  ceramic_density,
  ceramic_d31,
  ceramic_permittivity,
  electrodes_inner_radius,
  electrodes_outer_radius,
  contact_radius,
};

/// How many dimensions there are.
inline constexpr std::size_t kDimensions = static_cast<std::size_t>(Dimension::contact_radius) + 1;

/// A number with its derivatives with respect to every dimension, in the order of Dimension.
using Derived = Dual<double, static_cast<int>(kDimensions)>;

/// Derivative with respect to one dimension, in the SI units of both.
inline double derivative(const Derived& number, Dimension dimension) {
  return number.d[static_cast<std::size_t>(dimension)];
}

/// Name and unit of a dimension.
struct DimensionInfo {
  std::string_view name;  ///< entries joined by '_', such as "ceramic_thickness"
  std::string_view unit;  ///< SI; "1" if dimensionless
};

/// Name and unit of each dimension, in the order of Dimension.
const std::array<DimensionInfo, kDimensions>& dimension_table();

/// The member of a geometry that holds a dimension. Null if its block is absent, if the electrodes have the ceramic's
/// radius, and for the contact radius.
/// @{
double* find(StatorGeometry& geometry, Dimension dimension);
const double* find(const StatorGeometry& geometry, Dimension dimension);
/// @}

/// Everything that is wrong with the numbers of a stator, one sentence each, such as "ceramic_outer_radius must be at
/// most 30 mm (substrate_outer_radius), but is 31 mm"; empty if such a stator can exist.
std::vector<std::string> geometry_complaints(const StatorGeometry& geometry);

/// Does nothing if such a stator can exist.
/// @throws InputError with all complaints otherwise
void check_geometry(const StatorGeometry& geometry);

}  // namespace twum::inline v0_1::stator
