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
  std::string source{};  ///< origin of the motor, such as the path of its file; may be empty
};

/// The data sheet of a motor: drawing to scale, curves with the rated point, limits, electrical numbers, parameters,
/// and origin. One self-contained HTML file without scripts that prints on one A4 page. Depends on the arguments
/// only.
/// @throws InputError for a design that is not admissible, or a rated speed at or below the negative wave speed
std::string datasheet_html(const MotorFile& motor, const DatasheetOptions& options = {});

}  // namespace twum::inline v0_1::studies
