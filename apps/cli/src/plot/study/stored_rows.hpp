// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plot/chart.hpp"

#include <twum/io/result_store.hpp>

#include <vector>

namespace twum::cli {

/// The values of all rows by columns, in the order of the rows, SI; NaN where there is none. The store is read once, which takes
/// longer than a picture of its numbers.
class StoredValues {
 public:
  explicit StoredValues(const studies::ResultStore& store);

  const std::vector<studies::StoredColumn>& columns() const { return columns_; }
  const std::vector<double>& of(std::size_t column) const { return values_[column]; }
  /// Those of the column of this name; empty if there is none.
  const std::vector<double>& of(const studies::StoredColumn& column) const;

 private:
  const std::vector<studies::StoredColumn>& columns_;
  std::vector<std::vector<double>> values_;
  std::vector<double> none_{};
};

/// The axis of a column.
/// @param pad  room beyond the values, share of their span
Axis axis_of(const studies::StoredColumn& column, double pad);

/// More points than these on a picture of some 600 by 200 pixels only make its file longer.
inline constexpr std::size_t kMostPoints = 5000;

/// Rows that a picture shows if there are more than `most`: a random sample, always the same one. Taking every k-th
/// row would be wrong, because every k-th point of a grid or a sequence lies in a part of the space only.
std::vector<std::size_t> shown_rows(std::size_t count, std::size_t most = kMostPoints);

}  // namespace twum::cli
