// SPDX-License-Identifier: Apache-2.0
#include "plot/study/told_pictures.hpp"

#include "plot/style.hpp"

#include <twum/studies/telling.hpp>

#include <algorithm>
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
  const bool ends = std::isfinite(told.low);
  return {read(told.name), told.unit, told.zero, ends ? 0 : kPad, told.low, told.high};
}

Series bars_of(const telling::Chart& chart, const telling::Series& told, bool kept) {
  Series series{
      kept ? told.name : "breaks it", Draw::boxes, kept ? colour::kBlue : colour::kVermilion, {}};
  for (std::size_t i = 0; i < told.y.values.size(); ++i) {
    const double low = told.x.values[i], high = told.x.values[i + 1], middle = (low + high) / 2;
    if (told.y.values[i] > 0 && (middle >= chart.least && middle <= chart.most) == kept)
      series.rows.push_back({low, high, 0, told.y.values[i]});
  }
  return series;
}

Series outline_of(const telling::Series& told) {
  Series series{told.name, Draw::line, "#000000", {}};
  for (std::size_t i = 0; i < told.y.values.size(); ++i)
    for (const std::size_t end : {i, i + 1})
      series.rows.push_back({told.x.values[end], told.y.values[i]});
  return series;
}

void add_series(Panel& panel, const telling::Chart& chart, const telling::Series& told) {
  if (told.stroke == telling::Stroke::outline) return panel.series.push_back(outline_of(told));
  if (told.stroke == telling::Stroke::bars) {
    panel.series.push_back(bars_of(chart, told, true));
    if (std::isfinite(chart.least) || std::isfinite(chart.most))
      panel.series.push_back(bars_of(chart, told, false));
    return;
  }
  Series line{told.name, Draw::line, colour::kBlue, {}}, dots{"", Draw::dots, colour::kBlue, {}};
  for (std::size_t i = 0; i < told.y.values.size(); ++i)
    line.rows.push_back({told.x.values[i], told.y.values[i]});
  dots.rows = line.rows;
  panel.series.push_back(line);
  panel.series.push_back(dots);
}

Picture chart_picture(const FinishedStudy& study, const telling::Chart& chart) {
  Panel panel{axis_of(chart.x), axis_of(chart.y), {}};
  for (const telling::Series& series : chart.series) add_series(panel, chart, series);
  for (const telling::Guide& guide : chart.guides)
    panel.guides.push_back({guide.at, true, read(guide.text), colour::kVermilion});
  for (const telling::Mark& mark : chart.marks)
    panel.marks.push_back({mark.x, mark.y, read(mark.text)});
  return picture_of(file_word(chart.name), {study.title(read(chart.title)), {panel}});
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

}  // namespace

std::vector<Picture> told_pictures(const FinishedStudy& study) {
  std::vector<Picture> pictures;
  for (const telling::Section& section : telling::sections(study.result)) {
    for (const telling::Chart& chart : section.charts)
      pictures.push_back(chart_picture(study, chart));
    if (section.bars.of > 0 && !sorted_rows(section).empty())
      pictures.push_back(bars_picture(study, section));
  }
  return pictures;
}

}  // namespace twum::cli
