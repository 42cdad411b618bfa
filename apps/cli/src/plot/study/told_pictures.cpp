// SPDX-License-Identifier: Apache-2.0
#include "plot/study/told_pictures.hpp"

#include "plot/fields_plot.hpp"
#include "plot/study/parallel.hpp"
#include "plot/style.hpp"
#include "plot/told_panel.hpp"

#include <twum/core/metrics.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace twum::inline v0_1::cli {
namespace {

// A curve some 600 points of the page wide.
constexpr std::size_t kCurvePoints = 301;

std::string file_name(std::string name) {
  name.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(name.front())));
  return file_word(name);
}

// The charts of a section, with those of the others of its picture.
std::vector<telling::Chart> charts_of(const telling::Section& section,
                                      const std::vector<telling::Section>& all) {
  if (section.picture.empty()) return section.charts;
  std::vector<telling::Chart> charts;
  for (const telling::Section& other : all)
    if (other.picture == section.picture)
      charts.insert(charts.end(), other.charts.begin(), other.charts.end());
  return charts;
}

Picture chart_picture(const FinishedStudy& study, const telling::Section& section,
                      const std::vector<telling::Section>& all) {
  const std::vector<telling::Chart> charts = charts_of(section, all);
  const std::string what = charts.size() > section.charts.size() ? section.picture
                           : charts.size() == 1                  ? read(charts.front().title)
                                                                 : read(section.heading);
  const std::string name = !section.picture.empty() ? section.picture
                           : charts.size() == 1     ? charts.front().name
                                                    : file_name(what);
  return picture_of(file_word(name), told_chart(study.title(what), charts, section.columns));
}

bool is_maps(const telling::Section& section) {
  return !section.charts.empty() && !section.charts.front().colours.name.empty();
}

// Each map has a picture of its own, for the scale of its colours needs height.
void add_maps(std::vector<Picture>& pictures, const FinishedStudy& study,
              const telling::Section& section) {
  for (const telling::Chart& chart : section.charts)
    pictures.push_back(picture_of(file_word(chart.name),
                                  told_chart(study.title("map of " + read(chart.title)), {chart})));
}

// The contact of a motor alone at its peak power.
void add_fields(std::vector<Picture>& pictures, const FinishedStudy& study, const Motor& motor) {
  const MetricValue speed = evaluate(motor, {Metric::speed_at_peak_power, Argument::none, 0});
  if (speed.status != MetricStatus::ok ||
      motor.fields(speed.value, 2).point.status != PointStatus::ok)
    return;
  const studies::MotorFile at{study.title("at peak power"), motor.design()};
  pictures.push_back(
      {"fields", kFieldsPlotSize,
       motor.radial_slices() != 1 ? fields_map(at, speed.value) : fields_plot(at, speed.value)});
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

// Whether an earlier section has its charts in the same picture.
bool is_drawn(const std::vector<Picture>& pictures, const telling::Section& section) {
  return !section.picture.empty() &&
         std::ranges::find(pictures, section.picture, &Picture::name) != pictures.end();
}

}  // namespace

std::vector<Picture> told_pictures(const FinishedStudy& study) {
  const std::vector<telling::MotorCurve> curves =
      telling::motor_curves(study.result, kCurvePoints, telling::FrontCurves::ends);
  const std::vector<telling::Section> sections =
      telling::sections(study.result, {&study.file, &study.store, &curves});
  std::vector<Picture> pictures;
  for (const telling::Section& section : sections) {
    if (section.hook == "fields") {
      if (curves.size() == 1) add_fields(pictures, study, curves.front().motor);
    } else if (is_maps(section))
      add_maps(pictures, study, section);
    else if (!section.charts.empty() && !is_drawn(pictures, section))
      pictures.push_back(chart_picture(study, section, sections));
    if (section.bars.of > 0 && !sorted_rows(section).empty())
      pictures.push_back(bars_picture(study, section));
    if (!section.parallel.axes.empty())
      pictures.push_back(parallel_picture(study.title(read(section.heading)), section.parallel));
  }
  return pictures;
}

}  // namespace twum::inline v0_1::cli
