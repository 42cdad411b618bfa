// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "metrics/followed_wave.hpp"
#include "point/point.hpp"

#include <twum/core/load.hpp>
#include <twum/core/motor_design.hpp>

#include <optional>

namespace twum::inline v0_1::core {

/// A load at a worn track, solved.
struct SolvedLoad {
  DrivenMotor<double> motor;
  SolvedPoint point;
  double speed;  ///< of the rotor [rad/s]

  LoadWave wave() const { return {motor.mean.amplitude, speed}; }
};

/// The point that a load takes, from that of nearly the same motor; searched where this leads nowhere.
/// @param near  nothing: searched
/// @throws SearchFailure where there is none
SolvedLoad solved_load(const MotorDesign& worn, const LoadPoint& load,
                       const std::optional<LoadWave>& near);

}  // namespace twum::inline v0_1::core
