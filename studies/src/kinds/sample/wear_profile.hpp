// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/load.hpp>
#include <twum/core/motor_design.hpp>
#include <twum/studies/life_result.hpp>

namespace twum::inline v0_1::studies {

/// How fast each radius of the track of a motor wears by itself under a load (V1.1), by a mean over 2000 phases of the wave: to some
/// thousandths. At the reference temperature. Empty with one slice, without the load's point, and for a load that the drive holds.
std::vector<LifeResult::AtRadius> wear_profile(const MotorDesign& design, const LoadPoint& load);

}  // namespace twum::inline v0_1::studies
