// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motor.hpp>

namespace twum::core {

/// What the library's own sources take from a Motor.
struct MotorParts {
  /// The drive of a motor under a voltage, else null.
  static const Drive* drive(const Motor& motor) { return motor.drive(); }
  /// The modes of the stator, null without modal data.
  static const StatorModes<double>* modes(const Motor& motor) { return motor.modes_.get(); }
  static const DrivenMotor<double>& model(const Motor& motor) { return motor.model(); }
};

}  // namespace twum::core
