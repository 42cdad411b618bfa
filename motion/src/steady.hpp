// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "equations.hpp"

#include <vector>

namespace twum::inline v0_1::motion {

/// The steady running state under the inputs at the beginning of the equations' stretch, of a wave that
/// runs forward, to rounding.
/// @throws InputError if there is none.
States steady_state(const MotorDesign& design, Equations& equations);

/// dy/dq of a steady state y in each column of the equations' slopes, that of column k at [k n + i]; zero for what is not steady.
/// @throws InputError where the contact has no answer
std::vector<double> steady_slopes(Equations& equations, const States& y, std::size_t columns);

}  // namespace twum::inline v0_1::motion
