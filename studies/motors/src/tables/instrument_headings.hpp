// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tables/measured_columns.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace twum::inline v0_1::motors {

/// True for a heading that impedance analysers write, such as "Freq (Hz)", "Rs [Ohm]" or "|Z|".
bool is_instrument_heading(std::string_view heading);

/// Gives headings of impedance analysers their names here, where they have a frequency and a whole pair: G and B, or R and X, or
/// |Z| and its phase. Of several pairs the first in this order counts; all other columns are then unused. Returns what
/// the table is, such as "impedance analyser's table of R and X"; empty if it is none, or if a heading is a reading already.
std::string name_instrument_columns(std::vector<ColumnHeading>& headings);

}  // namespace twum::inline v0_1::motors
