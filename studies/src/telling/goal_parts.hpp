// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/telling.hpp>

#include <cstdint>
#include <string>
#include <vector>

/// Parts that the tellings of several kinds share; internal.
namespace twum::inline v0_1::studies::telling {

/// An amount of a goal or a change of it: a share of the motors in per cent, another one with its unit.
Part goal_part(const Goal& goal, double value, int digits = 4);
/// The value of a goal: the same, but an absolute temperature is in degC.
Part goal_part_of(const Goal& goal, double value);
/// The axis of a goal.
Axis goal_axis(const Goal& goal);
/// "largest peak power", "smallest max pressure"
Phrase goal_name(const Goal& goal);
/// True for the name of an absolute temperature, of a parameter, or of a metric at a point with it or without.
bool is_temperature(const std::string& name);
/// The value of a metric or a parameter: slices and whole numbers as a motor file has them, efficiencies in per cent, absolute
/// temperatures in degC.
Part named_part(const std::string& name, double value, const std::string& unit, int digits = 4);
/// A whole number, with all of its digits.
Part count_part(std::uint64_t count);
/// Digits that tell the ends of an interval apart: two of half its width, and four at least.
int interval_digits(double low, double high);
/// "a, b and c"
Phrase listed(const std::vector<Part>& parts, const std::string& last = " and ");
/// The names of these.
std::vector<Part> name_parts(const std::vector<std::string>& names);
/// A sentence of a book begins with a capital, also with a name.
Phrase capitalized(Phrase phrase);
/// The phrase with more behind it.
void append(Phrase& phrase, const Phrase& more);
/// All of it stands out.
Phrase strong(Phrase phrase);
/// A section that is nothing but a part of the page.
Section hooked(const std::string& hook);
/// The i-th of several colours.
std::string colour_of(std::size_t i);
/// The values of a column of the stored rows in their order; empty if there is none of this name.
std::vector<double> column_values(const ResultStore& rows, const std::string& name);

}  // namespace twum::inline v0_1::studies::telling
