// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/design/parameters.hpp>
#include <twum/stator/geometry.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

/// What a design with a geometry takes of its plate, and how that moves with the design.
namespace twum {

/// Radii of the track at which a mode's shape is taken, in half widths from its middle (P8.1): with the middle, where R = 1,
/// Chebyshev's points of the polynomial of degree 4.
inline constexpr std::array kShapePoints{-0.95105651629515357, -0.58778525229247313,
                                         0.58778525229247313, 0.95105651629515357};

/// Numbers of the plate that the motor takes: first those that are parameters without a geometry.
enum class PlateNumber : unsigned char {
  neutral_plane_distance,
  resonance_frequency,
  modal_mass,
  force_factor,
  blocked_capacitance,
  mode_separation,
  ceramic_stress,  ///< per amplitude
  shape            ///< the first of those at kShapePoints
};

inline constexpr std::size_t kPlateNumbers =
    static_cast<std::size_t>(PlateNumber::shape) + kShapePoints.size();

constexpr std::size_t index_of(PlateNumber number) { return static_cast<std::size_t>(number); }

/// The number of the plate that gives a parameter where a geometry does; nothing for all others.
std::optional<PlateNumber> plate_number_of(Parameter parameter);

/// Values in the order of PlateNumber; NaN where the geometry gives no plate. Never throws.
std::array<double, kPlateNumbers> plate_numbers(const MotorDesign& design);

/// How they move with each parameter in use, the others held. Whole numbers of waves move nothing: modes of 9 and 10
/// wavelengths are not steps on one way.
std::array<std::array<double, kParameterCount>, kPlateNumbers> plate_jacobian(
    const MotorDesign& design);

/// @name Parameters of the geometry
/// @{
bool is_of_geometry(Parameter parameter);
/// Value; NaN where the block is missing.
double get_of_geometry(const MotorDesign& design, Parameter parameter);
/// False where nothing follows from it: without its block, and a glue without thickness.
bool in_use_of_geometry(const MotorDesign& design, Parameter parameter);
/// @throws InputError if the design has no such block
void set_of_geometry(MotorDesign& design, Parameter parameter, double value);
/// @}

/// Why a parameter cannot be set: it follows from the geometry. Empty if it can.
std::string follows_from_geometry(const MotorDesign& design, Parameter parameter);

/// What is wrong with the geometry of a design, or with what stands beside it, in the form of complaints(); empty if nothing
/// is. A plate without a mode for the wave is no complaint.
std::vector<std::string> geometry_complaints(const MotorDesign& design);

}  // namespace twum
