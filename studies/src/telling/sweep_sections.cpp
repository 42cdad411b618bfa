// SPDX-License-Identifier: Apache-2.0
#include "telling/goal_parts.hpp"
#include "telling/tellings.hpp"

#include <twum/io/words.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace twum::inline v0_1::studies::telling {
namespace {

// Fewer points than these stand apart from each other on a line.
constexpr std::size_t kFewPoints = 300;

// The columns of the rows, read once.
class Columns {
 public:
  explicit Columns(const ResultStore& rows)
      : columns_(rows.columns()), values_(rows.columns().size()) {
    rows.read([&](const StoredRow& row) {
      for (std::size_t i = 0; i < values_.size(); ++i) values_[i].push_back(row.values[i]);
    });
  }

  const std::vector<StoredColumn>& all() const { return columns_; }

  Numbers of(const StoredColumn& column) const {
    const auto at = std::ranges::find(columns_, column.name, &StoredColumn::name);
    if (at == columns_.end()) return {};
    return {"rows/" + column.name, values_[static_cast<std::size_t>(at - columns_.begin())]};
  }

 private:
  std::vector<StoredColumn> columns_;
  std::vector<std::vector<double>> values_;
};

using SweptMetric = SweepResult::Metric;

Axis axis_of(const StoredColumn& column) { return {{name_part(column.name)}, column.unit}; }

Chart pair_chart(const std::string& name, const StoredColumn& across, const StoredColumn& up,
                 Stroke stroke, const Columns& columns) {
  Chart chart{
      name, {name_part(up.name), " over ", name_part(across.name)}, axis_of(across), axis_of(up)};
  chart.series = {{"", stroke, columns.of(across), columns.of(up)}};
  return chart;
}

// Of one variable, every metric over it.
Section lines(const SweepResult& answer, const Columns& columns) {
  const StoredColumn& variable = answer.variables.front();
  Section section{{"Metrics over the ", name_part(variable.name)}};
  section.picture = "lines";
  for (const SweptMetric& metric : answer.metrics) {
    Chart chart =
        pair_chart("line " + metric.column.name, variable, metric.column, Stroke::line, columns);
    if (answer.stored < kFewPoints) {
      chart.series.push_back(chart.series.front());
      chart.series.back().stroke = Stroke::dots;
    }
    section.charts.push_back(std::move(chart));
  }
  return section;
}

// A grid over two variables, whole.
bool is_map(const SweepResult& answer, const Columns& columns) {
  if (answer.sampling != "grid" || answer.variables.size() != 2) return false;
  const std::vector<double> x = columns.of(answer.variables[0]).values;
  const std::vector<double> y = columns.of(answer.variables[1]).values;
  const std::set<double> across(x.begin(), x.end()), up(y.begin(), y.end());
  return across.size() > 1 && up.size() > 1 && across.size() * up.size() == x.size();
}

// True if the metric changes where this variable is held.
bool changes_at(const Numbers& held, const Numbers& metric) {
  constexpr double kRounding = 1e-9;
  std::map<double, double> seen;
  for (std::size_t i = 0; i < held.values.size(); ++i) {
    const double value = metric.values[i];
    const auto [first, fresh] = seen.try_emplace(held.values[i], value);
    if (!fresh && std::fabs(value - first->second) > kRounding * std::fabs(first->second))
      return true;
  }
  return false;
}

// A picture has no room for more rows or columns of cells.
constexpr std::size_t kMostLines = 256;

std::set<double> distinct(const Numbers& numbers) {
  return {numbers.values.begin(), numbers.values.end()};
}

// Every k-th of the values, from the first on.
std::set<double> drawn_lines(const Numbers& numbers) {
  const std::set<double> all = distinct(numbers);
  const std::size_t every = (all.size() + kMostLines - 1) / kMostLines;
  std::set<double> drawn;
  std::size_t i = 0;
  for (const double value : all)
    if (i++ % every == 0) drawn.insert(value);
  return drawn;
}

void thin(Series& cells) {
  const std::set<double> across = drawn_lines(cells.x), up = drawn_lines(cells.y);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < cells.x.values.size(); ++i) {
    if (!across.contains(cells.x.values[i]) || !up.contains(cells.y.values[i])) continue;
    for (Numbers* numbers : {&cells.x, &cells.y, &cells.z})
      numbers->values[kept] = numbers->values[i];
    ++kept;
  }
  for (Numbers* numbers : {&cells.x, &cells.y, &cells.z}) numbers->values.resize(kept);
}

Chart map_chart(const SweepResult& answer, const SweptMetric& metric, const Columns& columns) {
  Chart chart = pair_chart("map " + metric.column.name, answer.variables[0], answer.variables[1],
                           Stroke::cells, columns);
  chart.title = {name_part(metric.column.name)};
  chart.series.front().z = columns.of(metric.column);
  thin(chart.series.front());
  chart.colours = axis_of(metric.column);
  return chart;
}

// A metric that changes with both variables says more than one that does not: it comes first.
Section map(const SweepResult& answer, const Columns& columns) {
  Section section{{"Map"}, {"The metric over the two variables."}};
  section.hook = "map";
  const auto is_thinned = [&](const StoredColumn& variable) {
    return distinct(columns.of(variable)).size() > kMostLines;
  };
  if (std::ranges::any_of(answer.variables, is_thinned))
    section.sentences.push_back(
        {"Pictures draw at most " + std::to_string(kMostLines) + " values of each variable."});
  for (const SweptMetric& metric : answer.metrics)
    if (metric.count > 0) section.charts.push_back(map_chart(answer, metric, columns));
  std::ranges::stable_partition(section.charts, [](const Chart& chart) {
    const Series& cells = chart.series.front();
    return changes_at(cells.x, cells.z) && changes_at(cells.y, cells.z);
  });
  return section;
}

// The first two metrics, or a metric over a variable; a page lets its reader choose others.
Section designs(const SweepResult& answer, const Columns& columns) {
  const StoredColumn& up = answer.metrics.back().column;
  Section section{{"Designs"}};
  section.hook = "designs";
  section.charts = {answer.metrics.size() > 1
                        ? pair_chart("designs", answer.metrics[0].column, answer.metrics[1].column,
                                     Stroke::dots, columns)
                        : pair_chart("designs", answer.variables[0], up, Stroke::dots, columns)};
  return section;
}

// Of many variables, a metric over each of them.
Section over_variables(const SweepResult& answer, const SweptMetric& metric,
                       const Columns& columns) {
  Section section{{name_part(metric.column.name), " of the designs"}};
  section.on_page = false;
  section.picture = "designs-" + metric.column.name;
  for (const StoredColumn& variable : answer.variables)
    section.charts.push_back(pair_chart("designs", variable, metric.column, Stroke::dots, columns));
  return section;
}

Section every_quantity(const Columns& columns) {
  Section section{{"All quantities"}};
  section.hook = section.parallel.name = "parallel";
  for (const StoredColumn& column : columns.all())
    section.parallel.axes.push_back({{name_part(column.name)}, column.unit, columns.of(column)});
  return section;
}

std::vector<Section> pictures(const SweepResult& answer, const Columns& columns) {
  const bool whole = is_map(answer, columns);
  std::vector<Section> list;
  if (answer.variables.size() == 1) list.push_back(lines(answer, columns));
  if (whole) list.push_back(map(answer, columns));
  if (!answer.metrics.empty()) list.push_back(designs(answer, columns));
  if (!whole && answer.variables.size() > 1)
    for (const SweptMetric& metric : answer.metrics)
      if (metric.count > 0) list.push_back(over_variables(answer, metric, columns));
  list.push_back(every_quantity(columns));
  list.push_back(hooked("filters"));
  return list;
}

Table sweep_table(const SweepResult& answer) {
  Table table{"spread", {{"metric"}, {"lowest"}, {"median"}, {"highest"}, {"designs"}}, {}};
  for (const SweepResult::Metric& metric : answer.metrics) {
    table.rows.push_back({{name_part(metric.column.name)}});
    for (const double value : {metric.min, metric.median, metric.max})
      table.rows.back().push_back({value_part(value, metric.column.unit)});
    table.rows.back().push_back({count_part(metric.count)});
  }
  return table;
}

// The designs with the least and the most of each metric.
Table ends_table(const SweepResult& answer) {
  Table table{"ends", {{"metric"}, {"lowest at"}, {"highest at"}}, {}};
  for (const SweepResult::Metric& metric : answer.metrics) {
    table.rows.push_back({{name_part(metric.column.name)}});
    std::vector<Phrase>& row = table.rows.back();
    if (metric.count == 0)
      row.insert(row.end(), 2, {"no design has a value"});
    else if (metric.min == metric.max)
      row.insert(row.end(), 2, {"the same in all designs"});
    else
      row.insert(row.end(),
                 {design_phrase(answer, metric.lowest), design_phrase(answer, metric.highest)});
  }
  return table;
}

}  // namespace

std::vector<Section> sections_of(const SweepResult& answer, const Sources& sources) {
  if (answer.stored == 0) return {};
  std::vector<Section> list;
  if (sources.rows != nullptr) list = pictures(answer, Columns(*sources.rows));
  Section spread{{"Spread of the metrics"}, {"Sampling: " + answer.sampling + "."}};
  if (answer.stored < answer.designs)
    spread.sentences = {{std::to_string(answer.stored) + " of " +
                         counted(answer.designs, "design") + " are computed."}};
  spread.tables = {sweep_table(answer)};
  spread.wide = false;
  Section ends{{"Extremes"}, {"The designs with the lowest and the highest value of each metric."}};
  ends.tables = {ends_table(answer)};
  list.insert(list.end(), {spread, ends, hooked("list")});
  return list;
}

}  // namespace twum::inline v0_1::studies::telling
