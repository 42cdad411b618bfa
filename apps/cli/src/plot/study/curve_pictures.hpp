// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plot/chart.hpp"

#include <twum/motors/motor_limit.hpp>
#include <twum/studies/study_file.hpp>
#include <twum/studies/study_result.hpp>

#include <string>
#include <vector>

namespace twum::cli {

/// A motor of an answer, with what the key calls it.
struct NamedMotor {
  std::string name;
  Motor motor;
};

/// The design of a study with some of its parameters replaced [SI]; no motor if they make none.
void add_motor(std::vector<NamedMotor>& motors, const std::string& name, const MotorDesign& base,
               const std::vector<studies::NamedValue>& values);

/// Torque, power and efficiency over speed with the fields at peak power of a motor alone; of several each quantity over each other.
/// @param limits  what the torque or the speed has to be, drawn with the torques
void add_curve_pictures(std::vector<Picture>& pictures, const std::string& title,
                        const std::vector<NamedMotor>& motors,
                        const std::vector<studies::MotorLimit>& limits = {});

}  // namespace twum::cli
