// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/motor_problem.hpp>

#include <string>

namespace twum::inline v0_1::studies {

/// "1 N.m, 40 rpm": the arguments of a metric at a torque and a speed, which are read as the same numbers.
std::string held_arguments(const DutyPoint& point);

}  // namespace twum::inline v0_1::studies
