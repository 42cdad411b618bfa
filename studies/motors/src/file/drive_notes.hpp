// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motor.hpp>
#include <twum/motors/model_notes.hpp>

#include <optional>

namespace twum::inline v0_1::motors {

/// The note that a motor under a voltage does not run or does not start by itself at rest, or has no dead wave
/// although that was asked for, with a voltage and a frequency that would help. Nothing for other motors. Takes some
/// milliseconds.
std::optional<ModelNote> drive_note(const Motor& motor);

}  // namespace twum::inline v0_1::motors
