// SPDX-License-Identifier: Apache-2.0
#include "plot/study/kinds.hpp"
#include "plot/study/parallel.hpp"
#include "plot/study/stored_rows.hpp"
#include "plot/style.hpp"

#include <twum/motors/plain_name.hpp>
#include <twum/studies/extent.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace twum::cli {
namespace {

using studies::StoredColumn;

// Of a sweep of one variable, every metric over it.
Picture swept_lines(const FinishedStudy& study, const studies::SweepResult& answer,
                    const StoredValues& values) {
  const std::vector<double>& x = values.of(answer.variables[0]);
  Chart chart{
      study.title("metrics over " + studies::plain_name(answer.variables[0].name)), {}, true};
  for (const studies::SweepResult::Metric& metric : answer.metrics) {
    const std::vector<double>& y = values.of(metric.column);
    std::map<double, double> sorted;
    for (std::size_t i = 0; i < x.size(); ++i) sorted[x[i]] = y[i];
    Series line{"", Draw::line, colour::kBlue, {}}, dots{"", Draw::dots, colour::kBlue, {}};
    for (const auto& [at, value] : sorted) line.rows.push_back({at, value});
    dots.rows = line.rows;
    chart.panels.push_back(
        {axis_of(answer.variables[0], 0.02), axis_of(metric.column, 0.1), {line, dots}});
  }
  return picture_of("lines", chart);
}

// The cells of a grid meet half way between its values; {value: {low, high}}.
std::map<double, std::pair<double, double>> cells_of(const std::set<double>& values) {
  const std::vector<double> at(values.begin(), values.end());
  std::map<double, std::pair<double, double>> cells;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const double below = i > 0 ? 0.5 * (at[i] - at[i - 1]) : 0.5 * (at[1] - at[0]);
    const double above = i + 1 < at.size() ? 0.5 * (at[i + 1] - at[i]) : below;
    cells[at[i]] = {at[i] - (i > 0 ? below : above), at[i] + above};
  }
  return cells;
}

// A grid over two variables, whole.
bool is_map(const studies::SweepResult& answer, const StoredValues& values) {
  if (answer.sampling != "grid" || answer.variables.size() != 2) return false;
  const std::vector<double>&x = values.of(answer.variables[0]), &y = values.of(answer.variables[1]);
  const std::set<double> across(x.begin(), x.end()), up(y.begin(), y.end());
  return across.size() > 1 && up.size() > 1 && across.size() * up.size() == x.size();
}

Picture swept_map(const FinishedStudy& study, const studies::SweepResult& answer,
                  const studies::SweepResult::Metric& metric, const StoredValues& values) {
  const std::vector<double>&x = values.of(answer.variables[0]), &y = values.of(answer.variables[1]);
  const auto across = cells_of({x.begin(), x.end()}), up = cells_of({y.begin(), y.end()});
  const std::vector<double>& z = values.of(metric.column);
  Series cells{"", Draw::cells, "", {}};
  for (std::size_t i = 0; i < z.size(); ++i) {
    const auto& [left, right] = across.at(x[i]);
    const auto& [low, high] = up.at(y[i]);
    if (std::isfinite(z[i])) cells.rows.push_back({left, right, low, high, z[i]});
  }
  Panel panel{axis_of(answer.variables[0], 0), axis_of(answer.variables[1], 0), {cells}};
  panel.colours = axis_of(metric.column, 0);
  return picture_of("map-" + file_word(metric.column.name),
                    {study.title("map of " + studies::plain_name(metric.column.name)), {panel}});
}

// Cells along either side of a density: some ten designs in each if they fill the picture, and at most as many as the page has.
std::size_t density_cells(std::size_t designs) {
  return std::clamp<std::size_t>(
      static_cast<std::size_t>(std::sqrt(static_cast<double>(designs) / 10)), 20, 100);
}

// Place of a value among n cells between two ends; the highest value belongs to the last cell.
std::size_t cell_of(double value, const studies::Extent& side, std::size_t n) {
  const double place = (value - side.low) / (side.high - side.low) * static_cast<double>(n);
  return std::min(static_cast<std::size_t>(place), n - 1);
}

// How many designs lie in each cell that has any, as rows of Draw::cells.
std::vector<std::vector<double>> counted_cells(const std::vector<double>& x,
                                               const std::vector<double>& y,
                                               const studies::Extent& across,
                                               const studies::Extent& up) {
  const std::size_t n = density_cells(x.size());
  std::map<std::pair<std::size_t, std::size_t>, double> counts;
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i)
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

// Draws designs as points. If there are too many to distinguish, draws a density that counts all of them.
Panel scatter(const StoredColumn& across, const StoredColumn& up, const std::vector<double>& x,
              const std::vector<double>& y) {
  Panel panel{axis_of(across, 0.03), axis_of(up, 0.06), {{"", Draw::dots, colour::kBlue, {}}}};
  studies::Extent sides[2];
  for (const double value : x) sides[0].add(value);
  for (const double value : y) sides[1].add(value);
  if (x.size() > kMostPoints && sides[0].low < sides[0].high && sides[1].low < sides[1].high) {
    panel.series = {{"", Draw::cells, "", counted_cells(x, y, sides[0], sides[1])}};
    panel.colours = {"designs in a cell", "1"};
    studies::Extent counts;
    for (const std::vector<double>& cell : panel.series.front().rows) counts.add(cell[4]);
    panel.colours.log = counts.high > 100;  // counts over several powers of ten
    return panel;
  }
  for (const std::size_t i : shown_rows(std::min(x.size(), y.size())))
    panel.series.front().rows.push_back({x[i], y[i]});
  return panel;
}

// All quantities of the designs in parallel coordinates.
Picture every_quantity(const FinishedStudy& study, const StoredValues& values) {
  constexpr std::size_t kMostLines = 1500;  // more would be one grey block
  std::vector<ParallelAxis> axes;
  for (std::size_t i = 0; i < values.columns().size(); ++i) {
    const StoredColumn& column = values.columns()[i];
    axes.push_back({studies::plain_name(column.name), column.unit, values.of(i)});
  }
  return parallel_picture("parallel", study.title("every quantity at once"), axes,
                          shown_rows(axes.front().values.size(), kMostLines));
}

// Of many variables, one metric over each of them.
Picture swept_scatter(const FinishedStudy& study, const studies::SweepResult& answer,
                      const studies::SweepResult::Metric& metric, const StoredValues& values) {
  Chart chart{study.title(studies::plain_name(metric.column.name) + " of the designs"), {}};
  for (const StoredColumn& variable : answer.variables)
    chart.panels.push_back(
        scatter(variable, metric.column, values.of(variable), values.of(metric.column)));
  return picture_of("designs-" + file_word(metric.column.name), chart);
}

}  // namespace

std::vector<Picture> pictures_of(const FinishedStudy& study, const studies::SweepResult& answer) {
  const StoredValues values(study.store);
  if (answer.variables.size() == 1) return {swept_lines(study, answer, values)};
  std::vector<Picture> pictures;
  const bool map = is_map(answer, values);
  for (const studies::SweepResult::Metric& metric : answer.metrics) {
    if (metric.count == 0) continue;
    pictures.push_back(map ? swept_map(study, answer, metric, values)
                           : swept_scatter(study, answer, metric, values));
  }
  if (answer.metrics.size() > 1) {
    const StoredColumn &a = answer.metrics[0].column, &b = answer.metrics[1].column;
    pictures.push_back(picture_of(
        "designs", {study.title("the designs"), {scatter(a, b, values.of(a), values.of(b))}}));
  }
  pictures.push_back(every_quantity(study, values));
  return pictures;
}

}  // namespace twum::cli
