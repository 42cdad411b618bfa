// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fmu/plant_motor.hpp"

#include <string>

namespace twum::inline v0_1::cli {

/// contact_table.c of an FMU: the numbers of a motor as constants of C, with the GUID by which unit and description know each
/// other.
std::string contact_source(const PlantMotor& motor, const std::string& guid);

}  // namespace twum::inline v0_1::cli
