// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/parameters.hpp>
#include <twum/stator/geometry.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

/// Numbers that a design with a geometry takes from its plate, and their derivatives by the design.
namespace twum::inline v0_1 {

/// Radii of the track at which a mode's shape is sampled, as distances from its middle in half widths (P8.1).
/// Together with the middle, where R = 1, they are the Chebyshev points of a polynomial of degree 4.
inline constexpr std::array kShapePoints{-0.95105651629515357, -0.58778525229247313,
                                         0.58778525229247313, 0.95105651629515357};

/// Numbers of the plate that the motor uses; first those that are parameters if there is no geometry.
enum class PlateNumber : unsigned char {
  neutral_plane_distance,
  resonance_frequency,
  modal_mass,
  force_factor,
  blocked_capacitance,
  mode_separation,
  ceramic_stress,  ///< per amplitude
  stator_mass,
  shape  ///< the first of those at kShapePoints
};

inline constexpr std::size_t kPlateNumbers =
    static_cast<std::size_t>(PlateNumber::shape) + kShapePoints.size();

constexpr std::size_t index_of(PlateNumber number) { return static_cast<std::size_t>(number); }

/// The number of the plate that determines a parameter of a design with a geometry; nothing for other parameters.
std::optional<PlateNumber> plate_number_of(Parameter parameter);

/// The dimension of the plate that moves with a parameter; nothing for parameters of which it does not depend.
std::optional<stator::Dimension> dimension_of(Parameter parameter);

/// Values in the order of PlateNumber; NaN where the geometry gives no plate, and for mode_separation, which takes modes of
/// other numbers of waves. Never throws.
std::array<double, kPlateNumbers> plate_numbers(const MotorDesign& design);

/// Their derivatives with respect to each parameter in use, the others held. They are 0 for the number of
/// wavelengths, since modes of 9 and 10 wavelengths are different modes.
std::array<std::array<double, kParameterCount>, kPlateNumbers> plate_jacobian(
    const MotorDesign& design);

/// @name Those of mode_separation
/// @{
double mode_separation(const MotorDesign& design);
std::array<double, kParameterCount> mode_separation_slopes(const MotorDesign& design);
/// @}

/// The complaint that a parameter follows from the geometry and cannot be set; empty if it can.
std::string follows_from_geometry(const MotorDesign& design, Parameter parameter);

/// What is wrong with the geometry of a design or with the parameters beside it, as complaints(); empty if nothing
/// is. A plate without a suitable mode is not an error here.
std::vector<std::string> geometry_complaints(const MotorDesign& design);

}  // namespace twum::inline v0_1
