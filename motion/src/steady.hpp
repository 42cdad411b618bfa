// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "equations.hpp"

namespace twum::motion {

/// The steady running state under the inputs at the beginning of the equations' stretch, of a wave that
/// runs forward, to rounding.
/// @throws InputError if there is none.
States steady_state(const MotorDesign& design, Equations& equations);

}  // namespace twum::motion
