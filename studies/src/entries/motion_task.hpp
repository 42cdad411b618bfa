// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motor_design.hpp>
#include <twum/motion/motion.hpp>
#include <twum/studies/study.hpp>

#include <vector>

/// What a study of a motion does to its motor; internal.
namespace twum::inline v0_1::studies {

/// The motor with what the study says of the load.
MotorDesign motion_motor(const MotionStudy& asked, const MotorDesign& motor);

/// Times of the rows.
std::vector<double> motion_times(const MotionStudy& asked);

/// The loop of the study on a motor; the study has one. Limits that are missing are NaN.
motion::SpeedControl speed_control(const MotionControl& asked, const MotorDesign& motor);

motion::PositionControl position_control(const MotionControl& asked, const MotorDesign& motor);

/// What is done to a motor of the study, without the times of samples.
motion::MotionTask motion_task(const MotionStudy& asked, const MotorDesign& motor);

}  // namespace twum::inline v0_1::studies
