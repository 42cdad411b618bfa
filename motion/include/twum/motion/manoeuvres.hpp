// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motion_metrics.hpp>
#include <twum/motion/integrator_version.hpp>

#include <memory>
#include <vector>

namespace twum::inline v0_1::motion {

/// Metrics of standard manoeuvres (M10.1) and of the plant near a steady state (M7.1, M4.5) for any study. A start of 30 ms takes
/// some 5 ms with one slice, and all its derivatives 10 to 15 times as long.
///
/// A start goes from rest, the layer relaxed, to the steady speed under the design's drive and load and a constant torque; a stop
/// from there, with the drive off, until friction holds the rotor. Derivatives of times and angles are exact in the parameters in
/// use; those of rates and gains are differences of exact Jacobians; dynamic_start_voltage has none.
std::unique_ptr<MotionMetrics> motion_metrics(const MotorDesign& design);
/// The same metrics with their derivatives in some parameters only, which take less time. Derivatives in others are NaN.
/// @param wanted  parameters in use
std::unique_ptr<MotionMetrics> motion_metrics(const MotorDesign& design,
                                              std::vector<Parameter> wanted);

/// True in a program that has them (provide_motion_metrics()): all that include this header, if there is an integrator.
inline const bool kHasMotionMetrics = has_integrator() && provide_motion_metrics(&motion_metrics);

}  // namespace twum::inline v0_1::motion
