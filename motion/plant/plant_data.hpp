// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "motion/plant/plant.h"

#include <twum/core/motor_design.hpp>
#include <twum/motion/plant_table.hpp>

namespace twum::inline v0_1::motion {

/// The numbers of a motor as plant.c takes them, without the tables of its contact.
PlantData plant_data(const MotorDesign& design, const PlantTable& table);

/// The drive of the design: switched on, without load.
PlantInputs plant_inputs(const PlantTable& table);

/// What rotor, load and driver of the design are.
PlantParameters plant_parameters(const PlantTable& table);

}  // namespace twum::inline v0_1::motion
