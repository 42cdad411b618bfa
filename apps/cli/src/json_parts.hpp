// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/metrics.hpp>
#include <twum/core/zone.hpp>
#include <twum/motors/motor_file.hpp>

#include <nlohmann/json.hpp>

#include <vector>

namespace twum::inline v0_1::cli {

using Json = nlohmann::ordered_json;

/// {"twum": version, "name": ..., "motor": {flat name: SI value}} with the parameters in use.
Json motor_json(const studies::MotorFile& motor);

/// [{"state": "slip+", "from": rad, "to": rad}]
Json zones_json(const std::vector<Zone>& zones);

/// A number, or null where there is none.
Json number_json(double value);

/// Units of every parameter in use, by flat name.
Json parameter_units_json(const studies::MotorFile& motor);

/// The text of a JSON document, with line end. Bytes that are not UTF-8 are replaced.
std::string json_text(const Json& json);

}  // namespace twum::inline v0_1::cli
