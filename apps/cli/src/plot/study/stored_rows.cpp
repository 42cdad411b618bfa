// SPDX-License-Identifier: Apache-2.0
#include "plot/study/stored_rows.hpp"

#include <twum/motors/plain_name.hpp>
#include <twum/optim/random.hpp>

#include <algorithm>

namespace twum::cli {
std::optional<std::size_t> column_of(const studies::ResultStore& store, const std::string& name) {
  const std::vector<studies::StoredColumn>& columns = store.columns();
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (columns[i].name == name) return i;
  return {};
}

std::vector<double> column_values(const studies::ResultStore& store, std::size_t column) {
  std::vector<double> values;
  store.read([&](const studies::StoredRow& row) { values.push_back(row.values[column]); });
  return values;
}

std::vector<double> column_values(const studies::ResultStore& store,
                                  const studies::StoredColumn& column) {
  const auto place = column_of(store, column.name);
  return place ? column_values(store, *place) : std::vector<double>{};
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
