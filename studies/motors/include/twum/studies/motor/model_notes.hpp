// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/design/motor_design.hpp>
#include <twum/core/performance/motor.hpp>

#include <string>
#include <vector>

namespace twum::studies {

/// A reason to doubt what the model says of a motor that is valid as it stands.
struct ModelNote {
  std::string topic;  ///< what it is about: the same words for every motor
  double size{0};     ///< how far off; only to compare notes of one topic
  std::string text;   ///< a sentence with the motor's numbers, without a full stop
};

/// What to know before believing numbers of this motor: parameters outside the ranges in which the
/// solver is tested (often a wrong unit), a layer too thick for a foundation, a contact that never
/// opens. Empty for a usual motor. About the time of one metric; throws nothing for a valid design.
std::vector<ModelNote> model_notes(const MotorDesign& design);
/// The same of a motor that is there already, which saves most of the time.
std::vector<ModelNote> model_notes(const Motor& motor);

/// The note on a layer too thick for a foundation; empty if it is thin, or does not touch.
std::string thick_layer_note(const MotorDesign& design);

/// The same; whether the width of the contact changes stall torque, no-load speed or peak power of a motor with one slice
/// by more than 2 %, measured with eight slices; of a motor under a voltage whether it runs at rest and starts by itself, with
/// the voltage and the frequency that it takes; and up to which speed a backward wave grows (D6.7, D6.8). Some milliseconds.
std::vector<ModelNote> model_notes_at_length(const MotorDesign& design);

}  // namespace twum::studies
