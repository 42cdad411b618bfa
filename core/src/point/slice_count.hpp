// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/motor_model.hpp"

namespace twum::core {

/// What a design says of its track. `auto` comes to so many nodes a panel that torque and powers are within 1e-6 of their
/// scales (W4.2), which takes a millisecond.
TrackRule track_rule(const MotorDesign& design);

}  // namespace twum::core
