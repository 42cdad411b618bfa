// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/motor/motor_file.hpp>

#include <optional>
#include <string>

namespace twum::studies {

/// What a data sheet says beside the numbers of the motor.
struct DatasheetOptions {
  /// Rotor speed of the rated point [rad/s]; none: that of the largest overall efficiency, or of the largest output power where
  /// the motor has no modal data.
  std::optional<double> rated_speed{};
  std::string source{};  ///< where the motor comes from, such as the path of its file; may be empty
};

/// The data sheet of a motor: drawing to scale, curves with the rated point, limits, electrical numbers, parameters, and where it
/// comes from. One HTML file without scripts that needs no other, and prints on one A4 page. A function of its arguments alone.
/// @throws InputError for a design that is not admissible, or a rated speed at or below the negative wave speed
std::string datasheet_html(const MotorFile& motor, const DatasheetOptions& options = {});

}  // namespace twum::studies
