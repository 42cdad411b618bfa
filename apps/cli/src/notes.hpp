// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motor_design.hpp>

#include <set>
#include <span>
#include <string>

namespace twum::inline v0_1::cli {

/// Prints the reasons to doubt the model for this motor on standard error, one line each.
/// @param said  notes that were shown before; a note is left out if one of these is its beginning
void print_model_notes(const MotorDesign& design, std::span<const std::string> said = {});

/// Prints the meaning of reasons for missing answers on standard error, one line each.
/// @param reasons  words such as "no-periodic-state"; unknown words are ignored
void explain_reasons(const std::set<std::string>& reasons);

}  // namespace twum::inline v0_1::cli
