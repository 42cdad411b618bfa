// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "equations.hpp"

#include <twum/motion/motion.hpp>

#include <span>

namespace twum::inline v0_1::motion {

/// What a state says of the motor, with a contact of its own.
MotionSample sample_at(const Equations& equations, double time, std::span<const double> y);

}  // namespace twum::inline v0_1::motion
