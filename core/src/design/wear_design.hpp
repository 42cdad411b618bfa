// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motor_design.hpp>

#include <string>

namespace twum {

/// The wear block, made if it is missing.
Wear& wear_of(MotorDesign& design);

/// The first thing that is wrong with the wear block, as complaints(); empty if nothing is.
std::string wear_complaint(const MotorDesign& design);

}  // namespace twum
