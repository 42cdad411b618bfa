// SPDX-License-Identifier: Apache-2.0
#include "report/encode.hpp"
#include "report/rows.hpp"

#include <twum/studies/extent.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace twum::inline v0_1::studies {
namespace {

// A picture of 800 pixels has cells of eight: fine enough for a shape, and the counts of ten columns are 2 MB.
constexpr std::size_t kCells = 100;

// The cell of a value, kCells where it has none. The highest value belongs to the last cell.
std::size_t cell_of(double value, const Extent& side) {
  if (!std::isfinite(value) || !(side.low < side.high)) return kCells;
  const double place = (value - side.low) / (side.high - side.low) * static_cast<double>(kCells);
  return std::min(static_cast<std::size_t>(place), kCells - 1);
}

std::vector<Extent> extents(const ResultStore& store) {
  std::vector<Extent> list(store.columns().size());
  store.read([&](const StoredRow& row) {
    for (std::size_t i = 0; i < list.size(); ++i) list[i].add(row.values[i]);
  });
  return list;
}

}  // namespace

Json densities_json(const ResultStore& store) {
  const std::vector<Extent> sides = extents(store);
  const std::size_t columns = sides.size();
  std::vector<std::vector<std::uint32_t>> counts(columns * columns);
  for (std::size_t i = 0; i < columns; ++i)
    for (std::size_t j = i + 1; j < columns; ++j)
      if (sides[i].low < sides[i].high && sides[j].low < sides[j].high)
        counts[i * columns + j].assign(kCells * kCells, 0);
  std::vector<std::size_t> cells(columns);
  store.read([&](const StoredRow& row) {
    for (std::size_t i = 0; i < columns; ++i) cells[i] = cell_of(row.values[i], sides[i]);
    for (std::size_t i = 0; i < columns; ++i)
      for (std::size_t j = i + 1; j < columns; ++j)
        if (cells[i] < kCells && cells[j] < kCells)
          ++counts[i * columns + j][cells[i] * kCells + cells[j]];
  });
  Json json{{"cells", kCells}, {"ranges", Json::array()}, {"counts", Json::object()}};
  for (const Extent& side : sides)
    json["ranges"].push_back({number_json(side.low), number_json(side.high)});
  for (std::size_t i = 0; i < columns; ++i)
    for (std::size_t j = i + 1; j < columns; ++j)
      if (!counts[i * columns + j].empty())
        json["counts"][std::to_string(i) + "," + std::to_string(j)] =
            base64(counts[i * columns + j]);
  return json;
}

}  // namespace twum::inline v0_1::studies
