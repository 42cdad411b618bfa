// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/namespaces.hpp>
#include <twum/core/motor.hpp>
#include <twum/core/motor_design.hpp>
#include <twum/core/parameters.hpp>

#include <string>
#include <vector>

namespace twum::inline v0_1::motors {

/// A reason to doubt the model for a valid motor.
struct ModelNote {
  std::string topic;  ///< subject, in the same words for every motor
  double size{0};     ///< severity; only to compare notes on one topic
  std::string text;   ///< a sentence with the motor's numbers, without a full stop
};

/// Reasons to doubt the numbers of this motor: parameters outside the ranges in which the solver is tested (often a
/// wrong unit), a layer too thick for an elastic foundation, a contact that never opens. Empty for a usual motor.
/// Takes about the time of one metric; never throws for a valid design.
std::vector<ModelNote> model_notes(const MotorDesign& design);
/// The same for a motor that was built before, which saves most of the time.
std::vector<ModelNote> model_notes(const Motor& motor);

/// Of these, the note on a parameter outside the range in which the solver is tested; empty inside. Only that on the preload
/// takes the time of a metric.
std::string tested_range_note(const MotorDesign& design, Parameter parameter);

/// The note on a layer too thick for an elastic foundation; empty if it is thin or does not touch.
std::string thick_layer_note(const MotorDesign& design);

/// The same and more, in some milliseconds. For a motor with one slice: whether the width of the contact changes
/// stall torque, no-load speed or peak power by more than 2 %, computed with eight slices (peak power not under a voltage
/// with static_friction above kinetic_friction). For a motor under a
/// voltage: whether it runs at rest and starts by itself, with the voltage and the frequency that this needs, and up
/// to which speed a backward wave grows (D6.7, D6.8).
std::vector<ModelNote> model_notes_at_length(const MotorDesign& design);

}  // namespace twum::inline v0_1::motors
