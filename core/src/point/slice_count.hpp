// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/motor_model.hpp"

namespace twum::inline v0_1::core {

/// What a design says of its track. `auto` comes to so many nodes a panel that torque and powers are within 1e-6 of their
/// scales (W4.2), which takes a millisecond.
TrackRule track_rule(const MotorDesign& design);

/// The design without its voltage, and with enough slices in place of `auto`: for numbers that the wave does not enter.
inline MotorDesign without_drive(MotorDesign design) {
  constexpr int kEnough = -8;  // nodes for a pressure that is smooth along the track
  design.stator.voltage.reset();
  if (design.stator.radial_slices == kAutoSlices) design.stator.radial_slices = kEnough;
  return design;
}

}  // namespace twum::inline v0_1::core
