// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "motion/plant/plant.h"

#include <twum/core/motor_design.hpp>
#include <twum/motion/plant_table.hpp>

#include <array>
#include <string>
#include <vector>

namespace twum::inline v0_1::cli {

/// A motor as plant.c takes it.
class PlantMotor {
 public:
  PlantMotor(const MotorDesign& design, const motion::PlantTable& table);
  PlantMotor(const PlantMotor&) = delete;  // data() points into it
  PlantMotor& operator=(const PlantMotor&) = delete;

  const PlantData& data() const { return data_; }
  const PlantInputs& first_inputs() const {
    return first_inputs_;
  }  ///< of the design, without load
  const PlantParameters& parameters() const { return parameters_; }

  /// A table of one side of data(), in the order torque, reactive and active stiffness.
  using Side = std::array<std::vector<float>, 3>;
  const Side& along() const { return along_; }
  const Side& against() const { return against_; }

 private:
  Side along_, against_;
  PlantData data_;
  PlantInputs first_inputs_;
  PlantParameters parameters_;
};

/// How a start and a stop by tables differ from those with the contact solved at each instant, by the same equations.
struct PlantCheck {
  std::string missing{};  ///< why there is no comparison; empty if there is one
  double speed_error{0};  ///< largest difference of the speed, over the largest speed
  double angle_error{0};  ///< of the angle in which the rotor stops, over that angle
};

/// Starts the motor from rest under its voltage, and stops it by switching it off, 20 ms each.
PlantCheck check_plant(const MotorDesign& design, const PlantMotor& motor);

}  // namespace twum::inline v0_1::cli
