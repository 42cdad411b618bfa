// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motor_design.hpp>
#include <twum/motion/motion.hpp>

namespace twum::motion {

/// Looks along the samples of an averaged motion for what it leaves out, and adds an event where that has grown 150-fold (G = 5 of
/// G' = rate, G >= 0): `squeals` for a free backward wave (D6.7), `bounces` for hops of the rotor (M4.5). Where a rate is not known
/// nothing grows. Some 50 microseconds a sample, and only with rotor_mass.
void add_what_is_left_out(const MotorDesign& design, const MotionTask& task, Motion& motion);

}  // namespace twum::motion
