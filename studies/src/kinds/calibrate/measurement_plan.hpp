// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinds/calibrate/measured_fit.hpp"

#include <twum/studies/calibrate_result.hpp>

#include <vector>

namespace twum::inline v0_1::studies {

/// The measurements that would reduce the confidence region of the estimates most, each given the ones before it
/// (L6.1, L6.2). They are of the measured kinds with their scatter, at other speeds or torques and other settings of
/// preload and voltage. Empty if the scatter is not known.
/// @param tables  names of the tables of measurements; a measurement is on the motor of one where these have values of
///                their own
std::vector<CalibrateResult::Planned> measurement_plan(const MeasuredFit& fit,
                                                       const optim::LeastSquaresResult& best,
                                                       const std::vector<std::string>& tables);

/// Assumed standard deviation of a first measurement, relative to the largest value of its kind.
inline constexpr double kFirstDeviation = 0.01;

/// Readings of a motor at a speed with the assumed standard deviation: the torque and, for a driven motor, current
/// and power. Readings for which the motor has no value are left out.
std::vector<MeasuredPoint> first_readings(const MotorDesign& motor);

/// The plan if nothing was measured. The first widths are those of the ranges.
/// @param readings  the fit of first_readings()
/// @param values    of the parameters, at which the gains are taken
std::vector<CalibrateResult::Planned> first_plan(const MeasuredFit& readings,
                                                 std::vector<double> values);

}  // namespace twum::inline v0_1::studies
