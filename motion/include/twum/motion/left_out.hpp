// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motor_design.hpp>
#include <twum/motion/motion.hpp>

namespace twum::inline v0_1::motion {

/// Looks along the samples of an averaged motion for what it leaves out, and adds an event where that has grown 150-fold (G = 5 of
/// G' = rate, G >= 0): `squeals` for a free backward wave (D6.7), `bounces` for hops of the rotor (M4.5). Where a rate is not known
/// nothing grows. Some 50 microseconds a sample, and only with rotor_mass; hops only where the motion does not have them itself.
///
/// `motion-too-fast` tells where even the slowest root of (M7.1) exceeds W / 30, the rate at which the contact forgets: it is then not
/// periodic at every instant. A faster root beside a slow one does not count, since it is settled all the time. Some 100 samples
/// are looked at.
///
/// The task's go_on() ends it.
void add_what_is_left_out(const MotorDesign& design, const MotionTask& task, Motion& motion);

}  // namespace twum::inline v0_1::motion
