// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/telling.hpp>

#include <string>
#include <vector>

/// Parts that the tellings of several kinds share; internal.
namespace twum::studies::telling {

/// The value of a goal: a share of the motors in per cent, another one with its unit.
Part goal_part(const Goal& goal, double value, int digits = 4);
/// The axis of a goal.
Axis goal_axis(const Goal& goal);
/// "a, b and c"
Phrase listed(const std::vector<Part>& parts, const std::string& last = " and ");
/// A sentence of a book begins with a capital, also with a name.
Phrase capitalized(Phrase phrase);
/// The phrase with more behind it.
void append(Phrase& phrase, const Phrase& more);

}  // namespace twum::studies::telling
