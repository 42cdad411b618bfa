// SPDX-License-Identifier: Apache-2.0
#include "plot/told_panel.hpp"

#include "plot/crowd.hpp"
#include "plot/style.hpp"

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::cli {
namespace {

// Room about the values, as the page has it.
constexpr double kPad = 0.09;

Axis axis_of(const telling::Axis& told) {
  const bool ends = std::isfinite(told.low) && std::isfinite(told.high);
  return {read(told.name), told.unit, told.zero, ends ? 0 : kPad, told.low, told.high};
}

std::string colour_named(const std::string& name) {
  if (name == "ink") return "#000000";
  if (name == "soft") return "#666666";
  if (name == "faint") return "#BBBBBB";
  return colour_of(static_cast<std::size_t>(name.at(1) - '0'));
}

double x_of(const std::vector<double>& row) { return row.front(); }

std::vector<std::vector<double>> rows_of(const telling::Series& told) {
  std::vector<std::vector<double>> rows;
  if (told.stroke == telling::Stroke::cells)
    return grid_cells(told.x.values, told.y.values, told.z.values);
  if (told.stroke == telling::Stroke::dots && told.y.values.size() > kMostPoints) {
    for (const std::size_t i : shown_rows(told.y.values.size()))
      rows.push_back({told.x.values[i], told.y.values[i]});
    return rows;
  }
  for (std::size_t i = 0; i < told.y.values.size(); ++i) {
    const double x = told.x.values[i], y = told.y.values[i];
    if (told.stroke == telling::Stroke::bars) {
      if (y > 0) rows.push_back({x, told.x.values[i + 1], 0, y});
    } else {
      rows.push_back({x, y});
      if (told.stroke == telling::Stroke::outline) rows.push_back({told.x.values[i + 1], y});
    }
  }
  if (told.stroke == telling::Stroke::line) std::ranges::stable_sort(rows, {}, &x_of);
  return rows;
}

Draw draw_of(telling::Stroke stroke) {
  using telling::Stroke;
  switch (stroke) {
    case Stroke::dashes: return Draw::dashes;
    case Stroke::dots: return Draw::dots;
    case Stroke::steps: return Draw::steps;
    case Stroke::bars: return Draw::boxes;
    case Stroke::cells: return Draw::cells;
    case Stroke::stack: return Draw::area;
    case Stroke::contour: return Draw::thin;
    case Stroke::line:
    case Stroke::path:
    case Stroke::area:
    case Stroke::outline: break;
  }
  return Draw::line;
}

// A name stands in the key once.
std::string key_name(const Panel& panel, const std::string& name) {
  const bool there = std::ranges::find(panel.series, name, &Series::name) != panel.series.end();
  return there ? "" : name;
}

// A band about the line where a state holds.
void add_state(Panel& panel, const telling::Series& told) {
  if (told.broad.empty()) return;
  double largest = 0;
  for (const double y : told.y.values) largest = std::max(largest, y);
  Series band{key_name(panel, told.state), Draw::band, colour_named(told.colour), {}};
  for (std::size_t i = 0; i < told.y.values.size(); ++i) {
    const double x = told.x.values[i];
    const bool here = std::ranges::any_of(
        told.broad, [x](const auto& range) { return range[0] <= x && x <= range[1]; });
    const auto [below, above] = band_about(here ? told.y.values[i] : kNoValue, largest);
    band.rows.push_back({x, below, above});
  }
  panel.series.push_back(std::move(band));
}

// Parts of a whole on top of each other, from the sums of those below.
void add_part(Panel& panel, const telling::Series& told, std::vector<double>& sums) {
  Series area{told.name, Draw::area, colour_named(told.colour), {}};
  sums.resize(told.y.values.size());
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const double below = sums[i], part = told.y.values[i];
    sums[i] += part >= 0 ? part : kNoValue;
    area.rows.push_back({told.x.values[i], std::isfinite(sums[i]) ? below : kNoValue, sums[i]});
  }
  panel.series.push_back(std::move(area));
}

// Triangles that point to the values that keep a limit.
void add_bounds(Panel& panel, const std::vector<telling::Bound>& bounds) {
  Series least{"at least", Draw::rises, "#000000", {}};
  Series most{"at most", Draw::falls, "#000000", {}};
  for (const telling::Bound& bound : bounds)
    (bound.least ? least : most).rows.push_back({bound.x, bound.y});
  for (Series* series : {&least, &most})
    if (!series->rows.empty()) panel.series.push_back(std::move(*series));
}

// A density that counts all dots, where there are too many to distinguish; false for others.
bool add_density(Panel& panel, const telling::Series& told) {
  if (told.stroke != telling::Stroke::dots || told.y.values.size() <= kMostPoints) return false;
  Series cells{"", Draw::cells, "", counted_cells(told.x.values, told.y.values)};
  if (cells.rows.empty()) return false;
  panel.colours = {"designs in a cell", "1"};
  const auto most =
      std::ranges::max(cells.rows, {}, [](const std::vector<double>& cell) { return cell[4]; });
  panel.colours.log = most[4] > 100;  // counts over several powers of ten
  panel.series.push_back(std::move(cells));
  return true;
}

void add_series(Panel& panel, const telling::Series& told) {
  const std::string colour = colour_named(told.colour);
  if (!told.low.values.empty()) {
    Series band{told.band, Draw::band, colour, {}};
    for (std::size_t i = 0; i < told.low.values.size(); ++i)
      if (std::isfinite(told.low.values[i]))
        band.rows.push_back({told.x.values[i], told.low.values[i], told.high.values[i]});
    panel.series.push_back(std::move(band));
  }
  Series series{key_name(panel, told.name), draw_of(told.stroke), colour, rows_of(told)};
  if (!series.rows.empty()) panel.series.push_back(std::move(series));
}

Guide guide_of(const telling::Guide& told) {
  using Kind = telling::Guide::Kind;
  const bool limit = told.kind == Kind::limit;
  return {told.at, told.kind != Kind::level, read(told.text),
          limit ? colour::kVermilion : "#444444", told.kind == Kind::quantile};
}

// The colour of a cell is that of the middle of its band.
void add_field(Panel& panel, const telling::Field& field) {
  if (field.levels.empty()) return;
  panel.colours = {read(field.name),     field.unit,         false, 0,
                   field.levels.front(), field.levels.back()};
  panel.bands = field.levels.size() - 1;
  Series cells{"", Draw::image, "", {}};
  const auto between = [](double from, double to, std::size_t i, std::size_t count) {
    return from + (to - from) * static_cast<double>(i) / static_cast<double>(count - 1);
  };
  for (std::size_t j = 0; j < field.rows; ++j)
    for (std::size_t i = 0; i < field.columns; ++i) {
      const signed char band = field.bands[j * field.columns + i];
      const auto k = static_cast<std::size_t>(std::max<signed char>(band, 0));
      cells.rows.push_back({between(field.left, field.right, i, field.columns),
                            between(field.bottom, field.top, j, field.rows),
                            band < 0 ? kNoValue : 0.5 * (field.levels[k] + field.levels[k + 1])});
    }
  panel.series.push_back(std::move(cells));
}

}  // namespace

Panel panel_of(const telling::Chart& chart) {
  Panel panel{axis_of(chart.x), axis_of(chart.y), {}};
  add_field(panel, chart.field);
  if (!chart.colours.name.empty()) panel.colours = {read(chart.colours.name), chart.colours.unit};
  std::vector<double> sums;
  for (const telling::Series& series : chart.series) add_state(panel, series);
  for (const telling::Series& series : chart.series)
    if (series.stroke == telling::Stroke::stack)
      add_part(panel, series, sums);
    else if (!add_density(panel, series))
      add_series(panel, series);
  add_bounds(panel, chart.bounds);
  for (const telling::Guide& guide : chart.guides) panel.guides.push_back(guide_of(guide));
  for (const telling::Mark& mark : chart.marks)
    panel.marks.push_back({mark.x, mark.y, read(mark.text), mark.dot, mark.line});
  for (const telling::Stretch& one : chart.shaded)
    panel.shaded.push_back({one.from, one.to, one.name});
  panel.one_scale = chart.one_scale;
  if (!chart.colours.name.empty()) panel.x.pad = panel.y.pad = 0;  // cells reach to the edges
  return panel;
}

Chart told_chart(const std::string& title, const std::vector<telling::Chart>& charts,
                 std::size_t columns) {
  Chart chart{title, {}, false, columns};
  for (const telling::Chart& told : charts) chart.panels.push_back(panel_of(told));
  chart.shared = std::ranges::all_of(chart.panels, [&](const Panel& panel) {
    return panel.x.name == chart.panels.front().x.name;
  });
  return chart;
}

std::string read(const telling::Phrase& phrase) {
  return telling::written(phrase, telling::Writing::read);
}

}  // namespace twum::inline v0_1::cli
