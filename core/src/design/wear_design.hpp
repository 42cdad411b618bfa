// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motor_design.hpp>

#include <string>

namespace twum::inline v0_1 {

/// The wear block, made if it is missing.
Wear& wear_of(MotorDesign& design);

/// chi = k_l / (k_l + k_s), the lining's part of a worn depth [1].
double lining_part(const Wear& wear);

/// s = E / E_lining of a motor that wears (V2.2) [1].
double softness(const MotorDesign& design);

/// How much the layer's effective thickness loses for a depth: s chi (V2.2) [1].
double thickness_share(const MotorDesign& design);

/// The first thing that is wrong with the wear block, as complaints(); empty if nothing is.
std::string wear_complaint(const MotorDesign& design);

}  // namespace twum::inline v0_1
