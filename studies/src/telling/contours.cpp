// SPDX-License-Identifier: Apache-2.0
#include "telling/contours.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace twum::inline v0_1::studies::telling {
namespace {

// A crossing of the level with a line of the grid between two neighbours: twice the number of the lower left one, plus
// 1 if the other lies above it.
using Crossing = std::size_t;
constexpr Crossing kNowhere = std::numeric_limits<Crossing>::max();

// The crossings that a line goes on to from each.
using Neighbours = std::map<Crossing, std::array<Crossing, 2>>;

void join(Neighbours& neighbours, Crossing a, Crossing b) {
  for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
    auto& two = neighbours.try_emplace(from, std::array{kNowhere, kNowhere}).first->second;
    two[two[0] == kNowhere ? 0 : 1] = to;
  }
}

// A line crosses a cell from side to side. Where it crosses all four, the mean of the corners tells which belong together.
void join_within(Neighbours& neighbours, const ValueGrid& grid, std::size_t i, std::size_t j,
                 double level) {
  const std::array corners{grid.at(i, j), grid.at(i + 1, j), grid.at(i + 1, j + 1),
                           grid.at(i, j + 1)};
  const std::size_t here = j * grid.columns + i, above = here + grid.columns;
  const std::array<Crossing, 4> sides{2 * here, 2 * (here + 1) + 1, 2 * above, 2 * here + 1};
  double mean = 0;
  for (const double value : corners) mean += value / 4;
  if (!std::isfinite(mean)) return;
  std::vector<Crossing> met;
  for (std::size_t k = 0; k < 4; ++k)
    if ((corners[k] < level) != (corners[(k + 1) % 4] < level)) met.push_back(sides[k]);
  if (met.size() == 2) join(neighbours, met[0], met[1]);
  if (met.size() != 4) return;
  const bool with_last = (corners[0] < level) != (mean < level);  // the first corner is cut off
  join(neighbours, met[0], met[with_last ? 3 : 1]);
  join(neighbours, met[2], met[with_last ? 1 : 3]);
}

void add_point(ContourLine& line, const ValueGrid& grid, Crossing crossing, double level) {
  const std::size_t node = crossing / 2, i = node % grid.columns, j = node / grid.columns;
  const bool up = crossing % 2 == 1;
  const double from = grid.at(i, j), to = up ? grid.at(i, j + 1) : grid.at(i + 1, j);
  const double share = (level - from) / (to - from);
  line.x.push_back(grid.x(static_cast<double>(i) + (up ? 0 : share)));
  line.y.push_back(grid.y(static_cast<double>(j) + (up ? share : 0)));
}

// Follows a line from a crossing to its end, or around, and takes it out of the neighbours.
ContourLine line_from(Neighbours& neighbours, const ValueGrid& grid, Crossing first, double level) {
  ContourLine line;
  Crossing before = kNowhere, here = first;
  for (auto found = neighbours.find(here); found != neighbours.end();
       found = neighbours.find(here)) {
    add_point(line, grid, here, level);
    const auto [a, b] = found->second;
    neighbours.erase(found);
    before = std::exchange(here, a == before ? b : a);
  }
  if (here == first && line.x.size() > 2) add_point(line, grid, first, level);  // it is closed
  return line;
}

}  // namespace

std::vector<ContourLine> contour_lines(const ValueGrid& grid, double level) {
  Neighbours neighbours;
  for (std::size_t j = 0; j + 1 < grid.rows; ++j)
    for (std::size_t i = 0; i + 1 < grid.columns; ++i) join_within(neighbours, grid, i, j, level);
  std::vector<Crossing> ends;
  for (const auto& [crossing, two] : neighbours)
    if (two[1] == kNowhere) ends.push_back(crossing);
  std::vector<ContourLine> lines;
  for (const Crossing end : ends)
    if (neighbours.contains(end)) lines.push_back(line_from(neighbours, grid, end, level));
  while (!neighbours.empty())
    lines.push_back(line_from(neighbours, grid, neighbours.begin()->first, level));
  std::ranges::stable_sort(lines, std::greater{}, [](const ContourLine& l) { return l.x.size(); });
  return lines;
}

std::vector<double> round_levels(const std::vector<double>& values) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const double value : values)
    if (std::isfinite(value)) low = std::fmin(low, value), high = std::fmax(high, value);
  constexpr double kOneValue = 1e-9;  // values that differ by less differ by rounding
  if (!(high - low > kOneValue * std::fmax(std::fabs(low), std::fabs(high)))) return {};
  const double rough = (high - low) / 10, power = std::pow(10, std::floor(std::log10(rough)));
  const double step = rough <= power       ? power
                      : rough <= 2 * power ? 2 * power
                      : rough <= 5 * power ? 5 * power
                                           : 10 * power;
  std::vector<double> levels;
  for (double i = std::floor(low / step); (i - 1) * step < high; ++i) levels.push_back(i * step);
  return levels;
}

}  // namespace twum::inline v0_1::studies::telling
