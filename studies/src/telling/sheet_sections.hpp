// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/load.hpp>
#include <twum/studies/telling.hpp>

#include <optional>
#include <vector>

/// What a data sheet says of a motor; internal.
namespace twum::inline v0_1::studies::telling {

/// "Travelling wave ultrasonic motor with 9 wavelengths, driven by 120 V rms at 40.8 kHz"
Phrase motor_phrase(const MotorDesign& design);

/// Curves with the rated point, cross-section, performance, rated point, electrical numbers, parameters, doubts about the model.
/// @param rated  a speed, or a torque that the drive holds at a speed; none: the point of the largest overall efficiency, or of the
///               largest power of a motor without modal data
std::vector<Section> sheet_sections(const Motor& motor, const std::optional<LoadPoint>& rated);

/// One side of the motor, cut along its axis, to scale.
Section cross_section(const MotorDesign& design);

}  // namespace twum::inline v0_1::studies::telling
