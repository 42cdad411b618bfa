// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tables/measured_columns.hpp"

#include <twum/motors/column_choice.hpp>

#include <string_view>
#include <vector>

namespace twum::inline v0_1::motors {

/// True if the choice names a column with this heading.
bool names(const ColumnChoice& choice, std::string_view heading);

/// Gives the chosen columns the headings of their quantities. Adds an error for a choice that finds no column, or one that is
/// chosen already.
void name_chosen_columns(const std::vector<ColumnChoice>& choices,
                         std::vector<ColumnHeading>& headings, SourceMark begin,
                         Diagnostics& diagnostics);

}  // namespace twum::inline v0_1::motors
