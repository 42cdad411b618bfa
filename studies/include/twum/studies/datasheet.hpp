// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/motors/motor_file.hpp>

#include <optional>
#include <string>

namespace twum::inline v0_1::studies {

/// Options of a data sheet.
struct DatasheetOptions {
  /// Rotor speed of the rated point [rad/s]. By default that of the largest overall efficiency, or of the largest
  /// output power if the motor has no modal data.
  std::optional<double> rated_speed{};
  /// Torque of the rated point [N m], which the drive holds at `rated_speed` by its `control` (held_point()). By default
  /// the drive has the setting of the motor file.
  std::optional<double> held_torque{};
  std::string source{};  ///< origin of the motor, such as the path of its file; may be empty
};

/// The data sheet of a motor: drawing to scale, curves with the rated point, limits, electrical numbers, parameters,
/// and origin. One self-contained HTML file without scripts that prints on one A4 page. Depends on the arguments
/// only.
/// @throws InputError for a design that is not admissible, a rated speed at or below the negative wave speed, or a held
///         torque without a rated speed above 0
std::string datasheet_html(const MotorFile& motor, const DatasheetOptions& options = {});

}  // namespace twum::inline v0_1::studies
