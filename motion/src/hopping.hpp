// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model.hpp"

#include <algorithm>
#include <complex>

namespace twum::motion {

/// Growth rate of hops of a rotor on the wave of a design with a given amplitude (M4.5) [1/s]; NaN where the contact has no answer.
/// @param design  with a given number of slices and rotor_mass
/// @param speed   of the rotor in the direction of the wave [rad/s]
double hopping_rate(const MotionModel& model, const MotorDesign& design, double speed);

/// The pole next to that of the rotor on the layer alone.
template <typename Poles>
Complex nearest_pole(const Poles& poles, Complex alone) {
  return *std::ranges::min_element(poles.begin(), poles.end(), {},
                                   [&](const Complex& p) { return std::abs(p - alone); });
}

}  // namespace twum::motion
