// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/performance/motor.hpp>
#include <twum/studies/motor/model_notes.hpp>

#include <optional>

namespace twum::studies {

/// That a motor under a voltage does not run or does not start by itself at rest, or has no dead wave where that is asked for, with
/// the voltage and the frequency that would do. Nothing for other motors. Some milliseconds.
std::optional<ModelNote> drive_note(const Motor& motor);

}  // namespace twum::studies
