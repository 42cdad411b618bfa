// SPDX-License-Identifier: Apache-2.0
#include "plot/crowd.hpp"

#include <twum/optim/random.hpp>
#include <twum/studies/extent.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace twum::inline v0_1::cli {
namespace {

// Cells along either side of a density: some ten designs in each if they fill the picture, and at most as many as a page has.
std::size_t density_cells(std::size_t designs) {
  return std::clamp<std::size_t>(
      static_cast<std::size_t>(std::sqrt(static_cast<double>(designs) / 10)), 20, 100);
}

// Place of a value among n cells between two ends; the highest value belongs to the last cell.
std::size_t cell_of(double value, const studies::Extent& side, std::size_t n) {
  const double place = (value - side.low) / (side.high - side.low) * static_cast<double>(n);
  return std::min(static_cast<std::size_t>(place), n - 1);
}

studies::Extent extent_of(const std::vector<double>& values) {
  studies::Extent side;
  for (const double value : values) side.add(value);
  return side;
}

// The cells of a grid meet half way between its values; {value: {low, high}}.
std::map<double, std::pair<double, double>> cells_of(const std::vector<double>& values) {
  const std::set<double> sorted(values.begin(), values.end());
  const std::vector<double> at(sorted.begin(), sorted.end());
  std::map<double, std::pair<double, double>> cells;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const double below = i > 0 ? 0.5 * (at[i] - at[i - 1]) : 0.5 * (at[1] - at[0]);
    const double above = i + 1 < at.size() ? 0.5 * (at[i + 1] - at[i]) : below;
    cells[at[i]] = {at[i] - (i > 0 ? below : above), at[i] + above};
  }
  return cells;
}

}  // namespace

std::vector<std::size_t> shown_rows(std::size_t count, std::size_t most) {
  const std::size_t every = std::max<std::size_t>(1, (count + most - 1) / most);
  std::vector<std::size_t> rows;
  for (std::size_t first = 0; first < count; first += every) {
    const std::size_t group = std::min(every, count - first);
    rows.push_back(first + optim::Random(0, 0, first).below(group));
  }
  return rows;
}

std::vector<std::vector<double>> counted_cells(const std::vector<double>& x,
                                               const std::vector<double>& y) {
  const studies::Extent across = extent_of(x), up = extent_of(y);
  if (!(across.low < across.high && up.low < up.high)) return {};
  const std::size_t n = density_cells(x.size());
  std::map<std::pair<std::size_t, std::size_t>, double> counts;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (std::isfinite(x[i]) && std::isfinite(y[i]))
      ++counts[{cell_of(x[i], across, n), cell_of(y[i], up, n)}];
  const auto edge = [&](const studies::Extent& side, std::size_t i) {
    return std::lerp(side.low, side.high, static_cast<double>(i) / static_cast<double>(n));
  };
  std::vector<std::vector<double>> rows;
  for (const auto& [cell, count] : counts)
    rows.push_back({edge(across, cell.first), edge(across, cell.first + 1), edge(up, cell.second),
                    edge(up, cell.second + 1), count});
  return rows;
}

std::vector<std::vector<double>> grid_cells(const std::vector<double>& x,
                                            const std::vector<double>& y,
                                            const std::vector<double>& z) {
  const auto across = cells_of(x), up = cells_of(y);
  std::vector<std::vector<double>> rows;
  for (std::size_t i = 0; i < z.size(); ++i) {
    const auto& [left, right] = across.at(x[i]);
    const auto& [low, high] = up.at(y[i]);
    if (std::isfinite(z[i])) rows.push_back({left, right, low, high, z[i]});
  }
  return rows;
}

}  // namespace twum::inline v0_1::cli
