// SPDX-License-Identifier: Apache-2.0
#include "plot/study/stored_rows.hpp"

#include <twum/motors/plain_name.hpp>
#include <twum/optim/random.hpp>

#include <algorithm>

namespace twum::cli {
StoredValues::StoredValues(const studies::ResultStore& store)
    : columns_(store.columns()), values_(columns_.size()) {
  for (std::vector<double>& column : values_) column.reserve(store.rows());
  store.read([&](const studies::StoredRow& row) {
    for (std::size_t i = 0; i < values_.size(); ++i) values_[i].push_back(row.values[i]);
  });
}

const std::vector<double>& StoredValues::of(const studies::StoredColumn& column) const {
  for (std::size_t i = 0; i < columns_.size(); ++i)
    if (columns_[i].name == column.name) return values_[i];
  return none_;
}

Axis axis_of(const studies::StoredColumn& column, double pad) {
  return {studies::plain_name(column.name), column.unit, false, pad};
}

std::vector<std::size_t> shown_rows(std::size_t count, std::size_t most) {
  const std::size_t every = std::max<std::size_t>(1, (count + most - 1) / most);
  std::vector<std::size_t> rows;
  for (std::size_t first = 0; first < count; first += every) {
    const std::size_t group = std::min(every, count - first);
    rows.push_back(first + optim::Random(0, 0, first).below(group));
  }
  return rows;
}

}  // namespace twum::cli
