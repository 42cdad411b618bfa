// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/metrics.hpp>
#include <twum/core/motor_design.hpp>

namespace twum::inline v0_1::motion {

/// Thrown where a metric of a motion has no value, with the reason.
struct WithoutValue {
  MetricStatus status;
};

/// A metric's value. @throws WithoutValue if it has none
double value_or_reason(const MetricValue& found);

/// Makes sure that a motor runs under its drive and a torque, friction of the load included.
/// @throws WithoutValue with the status of speed_at, and `undefined` for a motor without preload or friction: its rotor is free
void require_running(const MotorDesign& design, double torque);

}  // namespace twum::inline v0_1::motion
