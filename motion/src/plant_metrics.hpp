// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/metrics.hpp>
#include <twum/core/motor_design.hpp>

#include <array>

namespace twum::inline v0_1::motion {

/// True for rates and gains of the plant near a steady state.
bool is_of_plant(Metric metric);

/// Such a number.
/// @throws WithoutValue where the motor does not run, InputError as linearize() and bounce_rate()
double plant_number(const MotorDesign& design, const MetricRequest& request);

/// Its derivatives in all parameters in use, by differences of exact Jacobians. NaN for inertia and damping of a layer that has
/// none: there the number has no slope, since a layer of very little inertia rings.
/// @throws as plant_number(), at the design or beside it
std::array<double, kParameterCount> plant_gradient(const MotorDesign& design,
                                                   const MetricRequest& request);

}  // namespace twum::inline v0_1::motion
