// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinds/measured_fit.hpp"

#include <twum/studies/results/calibrate_result.hpp>

#include <vector>

namespace twum::studies {

/// The measurements that would shrink the region of the estimates most, each after the ones before it (L6.1, L6.2): of the
/// kinds that were measured, with their scatter, at other speeds or torques and under other settings of preload and voltage.
/// Empty where the scatter is not known.
std::vector<CalibrateResult::Planned> measurement_plan(const MeasuredFit& fit,
                                                       const optim::LeastSquaresResult& best);

/// Standard deviation of a first measurement, in parts of the largest value of its kind.
inline constexpr double kFirstDeviation = 0.01;

/// What a bench reads of a motor at a speed, with the standard deviation assumed: the torque and, of a driven motor, current and
/// power. A reading of which the motor has no value is left out.
std::vector<MeasuredPoint> first_readings(const MotorDesign& motor);

/// The plan where nothing was measured: widths are those of the ranges at first.
/// @param readings  the fit of first_readings()
/// @param values    of the parameters, at which the gains are taken
std::vector<CalibrateResult::Planned> first_plan(const MeasuredFit& readings,
                                                 std::vector<double> values);

}  // namespace twum::studies
