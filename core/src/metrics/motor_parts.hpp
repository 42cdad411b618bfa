// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "drive/lazy_drive.hpp"

#include <twum/core/motor.hpp>

namespace twum::inline v0_1::core {

/// What the library's own sources take from a Motor.
struct MotorParts {
  /// The drive of a motor under a voltage, else null.
  static const Drive* drive(const Motor& motor) { return motor.drive(); }
  /// The waves of a motor under a voltage: found without its running wave, but for `auto`, whose slices follow from that of one slice.
  static const DrivenWaves& waves(const Motor& motor) { return motor.drive_->waves(); }
  /// The waves at rest of a motor under a voltage, else null: found without its running wave.
  static const WavesAtRest* at_rest(const Motor& motor) {
    return motor.drive_ ? &motor.drive_->at_rest() : nullptr;
  }
  /// The modes of the stator, null without modal data.
  static const StatorModes<double>* modes(const Motor& motor) { return motor.modes_.get(); }
  static const DrivenMotor<double>& model(const Motor& motor) { return motor.model(); }
};

}  // namespace twum::inline v0_1::core
