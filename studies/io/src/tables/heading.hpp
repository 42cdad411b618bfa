// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace twum::inline v0_1::io {

/// A column's heading: "thickness [mm]" has the name "thickness" and the unit "mm". Views into the text.
struct Heading {
  std::string_view name;
  std::string_view unit;
  bool has_unit;
};

/// The ways to read a heading, the usual one first: "NAME [UNIT]" or a name alone, then "NAME (UNIT)" and "NAME / UNIT" if
/// UNIT is one.
std::vector<Heading> heading_forms(std::string_view text);

/// True for a unit, a peak value such as "Vpp", and what stands for none: nothing, "1", "-".
bool names_unit(std::string_view text);

/// The first word of a heading: letters, digits and underscores.
std::string_view first_word(std::string_view text);

}  // namespace twum::inline v0_1::io
