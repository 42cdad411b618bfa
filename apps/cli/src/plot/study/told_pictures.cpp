// SPDX-License-Identifier: Apache-2.0
#include "plot/study/told_pictures.hpp"

#include "plot/study/curve_pictures.hpp"
#include "plot/style.hpp"

#include <twum/studies/telling.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace twum::cli {
namespace {

namespace telling = studies::telling;

std::string read(const telling::Phrase& phrase) {
  return telling::written(phrase, telling::Writing::read);
}

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

std::vector<std::vector<double>> rows_of(const telling::Series& told) {
  std::vector<std::vector<double>> rows;
  for (std::size_t i = 0; i < told.y.values.size(); ++i) {
    const double x = told.x.values[i], y = told.y.values[i];
    if (told.stroke == telling::Stroke::bars) {
      if (y > 0) rows.push_back({x, told.x.values[i + 1], 0, y});
    } else {
      rows.push_back({x, y});
      if (told.stroke == telling::Stroke::outline) rows.push_back({told.x.values[i + 1], y});
    }
  }
  return rows;
}

Draw draw_of(telling::Stroke stroke) {
  using telling::Stroke;
  switch (stroke) {
    case Stroke::dashes: return Draw::dashes;
    case Stroke::dots: return Draw::dots;
    case Stroke::steps: return Draw::steps;
    case Stroke::bars: return Draw::boxes;
    case Stroke::contour: return Draw::thin;
    case Stroke::line:
    case Stroke::path:
    case Stroke::outline: break;
  }
  return Draw::line;
}

void add_series(Panel& panel, const telling::Series& told) {
  const bool named =
      std::ranges::find(panel.series, told.name, &Series::name) != panel.series.end();
  const std::string colour = colour_named(told.colour);
  if (!told.low.values.empty()) {
    Series band{told.band, Draw::band, colour, {}};
    for (std::size_t i = 0; i < told.low.values.size(); ++i)
      if (std::isfinite(told.low.values[i]))
        band.rows.push_back({told.x.values[i], told.low.values[i], told.high.values[i]});
    panel.series.push_back(std::move(band));
  }
  Series series{named ? "" : told.name, draw_of(told.stroke), colour, rows_of(told)};
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

Panel panel_of(const telling::Chart& chart) {
  Panel panel{axis_of(chart.x), axis_of(chart.y), {}};
  add_field(panel, chart.field);
  for (const telling::Series& series : chart.series) add_series(panel, series);
  for (const telling::Guide& guide : chart.guides) panel.guides.push_back(guide_of(guide));
  for (const telling::Mark& mark : chart.marks)
    panel.marks.push_back({mark.x, mark.y, read(mark.text), mark.dot});
  panel.one_scale = chart.one_scale;
  return panel;
}

// Several charts are panels over one axis.
Picture chart_picture(const FinishedStudy& study, const telling::Section& section) {
  const bool one = section.charts.size() == 1;
  Chart chart{study.title(read(one ? section.charts.front().title : section.heading)),
              {},
              !one,
              section.columns};
  for (const telling::Chart& told : section.charts) chart.panels.push_back(panel_of(told));
  std::string name = one ? section.charts.front().name : read(section.heading);
  name.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(name.front())));
  return picture_of(file_word(name), chart);
}

using Row = std::vector<telling::Phrase>;

// The number of a cell; NaN where the bars have no such column.
double number(const Row& row, std::size_t column) {
  return column > 0 ? row[column].front().value : kNoValue;
}

// Rows that have a bar, the longest last: the vertical axis rises.
std::vector<Row> sorted_rows(const telling::Section& section) {
  std::vector<Row> rows = section.tables.front().rows;
  std::erase_if(rows, [&](const Row& row) { return !std::isfinite(number(row, section.bars.of)); });
  std::ranges::stable_sort(rows, {},
                           [&](const Row& row) { return std::fabs(number(row, section.bars.of)); });
  return rows;
}

Picture bars_picture(const FinishedStudy& study, const telling::Section& section) {
  const telling::Bars& bars = section.bars;
  const bool parts = bars.inner > 0;
  Series outer{bars.of_name, Draw::boxes, parts ? "#8CC5E3" : colour::kBlue, {}};
  Series falls{"", Draw::boxes, colour::kVermilion, {}};
  Series inner{bars.inner_name, Draw::boxes, colour::kBlue, {}};
  Series intervals{"interval", Draw::intervals, "#000000", {}};
  Panel panel{{read(bars.axis), bars.unit, true, 0.05}, {}, {}};
  const std::vector<Row> rows = sorted_rows(section);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double at = static_cast<double>(i), value = number(rows[i], bars.of);
    const double high = number(rows[i], bars.high), part = number(rows[i], bars.inner);
    panel.y.words.push_back(read(rows[i].front()));
    (bars.both_ways && value < 0 ? falls : outer)
        .rows.push_back({0, bars.both_ways ? value : std::fabs(value), at - 0.32, at + 0.32});
    if (std::isfinite(part)) inner.rows.push_back({0, std::max(part, 0.0), at - 0.16, at + 0.16});
    if (std::isfinite(high)) intervals.rows.push_back({value, at, number(rows[i], bars.low), high});
  }
  panel.y.low = -0.6;
  panel.y.high = static_cast<double>(rows.size()) - 0.4;
  for (Series* series : {&outer, &falls, &inner, &intervals})
    if (!series->rows.empty()) panel.series.push_back(std::move(*series));
  return picture_of(file_word(bars.name), {study.title(read(bars.title)), {panel}});
}

// The curve of the study's motor.
void add_motor_pictures(std::vector<Picture>& pictures, const FinishedStudy& study) {
  std::vector<NamedMotor> motors;
  add_motor(motors, "motor", study.result.design, {});
  add_curve_pictures(pictures, study.title("the motor"), motors);
}

}  // namespace

std::vector<Picture> told_pictures(const FinishedStudy& study) {
  std::vector<Picture> pictures;
  for (const telling::Section& section :
       telling::sections(study.result, {&study.file, &study.store})) {
    if (!section.charts.empty()) pictures.push_back(chart_picture(study, section));
    if (section.bars.of > 0 && !sorted_rows(section).empty())
      pictures.push_back(bars_picture(study, section));
    if (section.hook == "motor") add_motor_pictures(pictures, study);
  }
  return pictures;
}

}  // namespace twum::cli
