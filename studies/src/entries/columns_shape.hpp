// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/io/shape.hpp>
#include <twum/motors/column_choice.hpp>

#include <vector>

/// The entry `columns`: what the columns of a table are; internal.
namespace twum::inline v0_1::studies::shapes {

/// Quantities by name, each with the heading or the number of its column, or a mapping of `column`, `unit` and `sign`.
Shape<std::vector<ColumnChoice>> columns();

}  // namespace twum::inline v0_1::studies::shapes
