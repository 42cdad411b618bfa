// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motor_design.hpp>
#include <twum/core/parameters.hpp>

#include <string>
#include <utility>
#include <vector>

namespace twum::inline v0_1::motors {

/// What a motor takes from its stator as a solid, and of which stator.
struct SolidData {
  /// resonance_frequency, modal_mass, force_factor, blocked_capacitance and neutral_plane_distance.
  std::vector<ParameterValue> numbers{};
  std::vector<std::pair<double, double>> shape{};  ///< radius [m] and R across the ring
  std::vector<ParameterValue> drawing{};           ///< see drawing_of()
  stator::InnerEdge inner_edge{};                  ///< what holds the stator
};

/// The parameters that determine the solid of a design with a geometry: all of the geometry but the stiffness_share of the teeth, which
/// only the plate needs, and wavelengths and contact_radius.
std::vector<ParameterValue> drawing_of(const MotorDesign& design);

/// The text of a file with such data, with SI values to the last digit.
/// @param name  of the motor, for the comment
std::string solid_text(const SolidData& data, const std::string& name);

/// Reads such a file.
/// @throws FileError with everything that is wrong in it; InputError if it cannot be read
SolidData read_solid_file(const std::string& path);

/// Differences between the drawing that the data were computed for and that of a design, such as "ceramic_thickness is 0.6 mm, but
/// was 0.5 mm"; empty if there are none.
std::vector<std::string> changes_since(const SolidData& data, const MotorDesign& design);

/// A design with these data in place of its geometry.
MotorDesign with_solid(MotorDesign design, const SolidData& data);

}  // namespace twum::inline v0_1::motors
