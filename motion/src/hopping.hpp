// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model.hpp"

namespace twum::inline v0_1::motion {

/// Growth rate of hops of a rotor on the wave of a design with a given amplitude (M4.5) [1/s]; NaN where the contact has no answer.
/// @param design  with a given number of slices and rotor_mass
/// @param speed   of the rotor in the direction of the wave [rad/s]
double hopping_rate(const MotionModel& model, const MotorDesign& design, double speed);

}  // namespace twum::inline v0_1::motion
