// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fmu/plant_motor.hpp"

#include <string>

namespace twum::inline v0_1::cli {

/// A motor as a unit of FMI 2.0 for co-simulation.
struct Fmu {
  std::string bytes;     ///< of the archive
  std::string platform;  ///< of its binary, such as "linux64"; empty without one
  std::string problem;   ///< why it has none
};

/// @param name  of the motor, for people; its letters and digits name the model
Fmu make_fmu(const PlantMotor& motor, const std::string& name);

}  // namespace twum::inline v0_1::cli
