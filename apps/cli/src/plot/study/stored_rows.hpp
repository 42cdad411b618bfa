// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plot/chart.hpp"

#include <twum/io/result_store.hpp>

#include <optional>
#include <string>
#include <vector>

namespace twum::cli {

/// The place of a column; nothing if there is none of this name.
std::optional<std::size_t> column_of(const studies::ResultStore& store, const std::string& name);

/// Values of one column, of all rows in their order, SI; NaN where there is none.
std::vector<double> column_values(const studies::ResultStore& store, std::size_t column);

/// The same of the column of this name; empty if there is none.
std::vector<double> column_values(const studies::ResultStore& store,
                                  const studies::StoredColumn& column);

/// The axis of a column.
/// @param pad  room beyond the values, share of their span
Axis axis_of(const studies::StoredColumn& column, double pad);

/// More points than these on a picture of some 600 by 200 pixels only make its file longer.
inline constexpr std::size_t kMostPoints = 5000;

/// Rows that a picture shows if there are more than `most`: a random sample, always the same one. Taking every k-th
/// row would be wrong, because every k-th point of a grid or a sequence lies in a part of the space only.
std::vector<std::size_t> shown_rows(std::size_t count, std::size_t most = kMostPoints);

}  // namespace twum::cli
