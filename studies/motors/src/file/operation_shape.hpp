// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/load.hpp>
#include <twum/io/shape.hpp>

#include <vector>

namespace twum::inline v0_1::motors {

/// Entries of `operation`: phases with a load, or idle ones.
const Shape<std::vector<LoadPhase>>& operation_shape();

/// Adds errors for phases that contradict the rest of the motor; false if there are any.
/// @param has_voltage  the motor is given by its voltage
bool check_operation(const std::vector<LoadPhase>& phases, bool has_voltage, const Given& motor,
                     Diagnostics& diagnostics);

}  // namespace twum::inline v0_1::motors
