// SPDX-License-Identifier: Apache-2.0
#include "plot/study/kinds.hpp"
#include "plot/study/stored_rows.hpp"
#include "plot/style.hpp"

#include <twum/studies/metrics/plain_name.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace twum::cli {
namespace {

using studies::StoredColumn;

// Of a sweep of one variable, every metric over it.
Picture swept_lines(const FinishedStudy& study, const studies::SweepResult& answer) {
  const std::vector<double> x = column_values(study.store, answer.variables[0]);
  Chart chart{
      study.title("metrics over " + studies::plain_name(answer.variables[0].name)), {}, true};
  for (const studies::SweepResult::Metric& metric : answer.metrics) {
    const std::vector<double> y = column_values(study.store, metric.column);
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
bool is_map(const studies::SweepResult& answer, const std::vector<std::vector<double>>& x) {
  if (answer.sampling != "grid" || x.size() != 2) return false;
  const std::set<double> across(x[0].begin(), x[0].end()), up(x[1].begin(), x[1].end());
  return across.size() > 1 && up.size() > 1 && across.size() * up.size() == x[0].size();
}

Picture swept_map(const FinishedStudy& study, const studies::SweepResult& answer,
                  const studies::SweepResult::Metric& metric,
                  const std::vector<std::vector<double>>& x) {
  const auto across = cells_of({x[0].begin(), x[0].end()}),
             up = cells_of({x[1].begin(), x[1].end()});
  const std::vector<double> values = column_values(study.store, metric.column);
  Series cells{"", Draw::cells, "", {}};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto& [left, right] = across.at(x[0][i]);
    const auto& [low, high] = up.at(x[1][i]);
    if (std::isfinite(values[i])) cells.rows.push_back({left, right, low, high, values[i]});
  }
  Panel panel{axis_of(answer.variables[0], 0), axis_of(answer.variables[1], 0), {cells}};
  panel.colours = axis_of(metric.column, 0);
  return picture_of("map-" + file_word(metric.column.name),
                    {study.title("map of " + studies::plain_name(metric.column.name)), {panel}});
}

Panel scatter(const StoredColumn& across, const StoredColumn& up, const std::vector<double>& x,
              const std::vector<double>& y) {
  Panel panel{axis_of(across, 0.03), axis_of(up, 0.06), {{"", Draw::dots, colour::kBlue, {}}}};
  for (const std::size_t i : shown_rows(std::min(x.size(), y.size())))
    panel.series.front().rows.push_back({x[i], y[i]});
  return panel;
}

// Of many variables, one metric over each of them.
Picture swept_scatter(const FinishedStudy& study, const studies::SweepResult& answer,
                      const studies::SweepResult::Metric& metric,
                      const std::vector<std::vector<double>>& x) {
  const std::vector<double> y = column_values(study.store, metric.column);
  Chart chart{study.title(studies::plain_name(metric.column.name) + " of the designs"), {}};
  for (std::size_t i = 0; i < x.size(); ++i)
    chart.panels.push_back(scatter(answer.variables[i], metric.column, x[i], y));
  return picture_of("designs-" + file_word(metric.column.name), chart);
}

}  // namespace

std::vector<Picture> pictures_of(const FinishedStudy& study, const studies::SweepResult& answer) {
  std::vector<Picture> pictures;
  if (answer.variables.size() == 1) return {swept_lines(study, answer)};
  std::vector<std::vector<double>> x;
  for (const StoredColumn& variable : answer.variables)
    x.push_back(column_values(study.store, variable));
  const bool map = is_map(answer, x);
  for (const studies::SweepResult::Metric& metric : answer.metrics) {
    if (metric.count == 0) continue;
    pictures.push_back(map ? swept_map(study, answer, metric, x)
                           : swept_scatter(study, answer, metric, x));
  }
  if (answer.metrics.size() > 1) {
    const StoredColumn &a = answer.metrics[0].column, &b = answer.metrics[1].column;
    pictures.push_back(picture_of("designs", {study.title("the designs"),
                                              {scatter(a, b, column_values(study.store, a),
                                                       column_values(study.store, b))}}));
  }
  return pictures;
}

}  // namespace twum::cli
