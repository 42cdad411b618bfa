// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fmu/plant_motor.hpp"

#include <string>

namespace twum::inline v0_1::cli {

/// Names by which tools know an FMU.
struct FmuIdentity {
  std::string name;        ///< for people
  std::string identifier;  ///< of C, and of the binary
  std::string guid;
};

/// modelDescription.xml of FMI 2.0 for co-simulation.
std::string model_description(const PlantMotor& motor, const FmuIdentity& identity);

}  // namespace twum::inline v0_1::cli
