// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/design/motor_design.hpp>

#include <set>
#include <span>
#include <string>

namespace twum::cli {

/// Says on standard error what to know before believing numbers of this motor, a line each.
/// @param said  notes that were shown before; one of these that a motor's note begins stands for it
void print_model_notes(const MotorDesign& design, std::span<const std::string> said = {});

/// Says on standard error what the reasons for missing answers mean, a line each.
/// @param reasons  words such as "no-periodic-state"; others than those known are left alone
void explain_reasons(const std::set<std::string>& reasons);

}  // namespace twum::cli
