// SPDX-License-Identifier: Apache-2.0
#include "results/calibration_tables.hpp"

#include <twum/io/engineering.hpp>
#include <twum/io/number.hpp>
#include <twum/io/text_table.hpp>

#include <algorithm>
#include <cmath>

namespace twum::studies {
namespace {

std::string argument_words(const CalibrateResult::Point& point) {
  return engineering(point.at, point.argument == Argument::speed ? "rad/s" : "N.m", 4);
}

// "speed_at(500 mN.m), preload 160 N"
std::string reading_words(const CalibrateResult::Point& point) {
  std::string words = point.quantity;
  if (point.argument != Argument::none) words += "(" + argument_words(point) + ")";
  for (const NamedValue& set : point.set)
    words += ", " + set.name + " " + engineering(set.value, set.unit, 4);
  return words;
}

}  // namespace

std::string place_words(const CalibrateResult::Point& point) {
  const std::string of = point.torque() ? "" : " of " + point.quantity;
  return point.argument == Argument::none ? of : of + " at " + argument_words(point);
}

std::string data_table(const CalibrateResult& result) {
  const bool torques = std::all_of(result.data.begin(), result.data.end(),
                                   [](const auto& point) { return point.torque(); });
  constexpr std::size_t kMost = 20;  // more are read in summary.json or on the page
  if (torques || result.data.size() > kMost) return {};
  TextTable table;
  table.rows.push_back({"what", "measured", "fitted", "deviations"});
  for (const CalibrateResult::Point& point : result.data) {
    const double part = point.residual / point.deviation;
    table.rows.push_back({reading_words(point), engineering(point.value, point.unit, 4),
                          engineering(point.fitted, point.unit, 4),
                          point.deviation > 0 ? rounded_text(part, 2) : "-"});
  }
  return aligned(table) + "\n";
}

namespace {

std::string plan_rows(const CalibrateResult& result, const char* heading) {
  TextTable table;
  table.rows.push_back({heading, "all"});
  for (const auto& e : result.estimates) table.rows[0].push_back(e.parameter.name);
  for (const CalibrateResult::Planned& planned : result.plan) {
    const auto shown = [](double part) { return rounded_text(100 * part, 3) + " %"; };
    const std::string file = planned.file.empty() ? "" : " (" + planned.file + ")";
    table.rows.push_back({reading_words(planned.point) + file, shown(planned.mean)});
    for (const double width : planned.widths) table.rows.back().push_back(shown(width));
  }
  return aligned(table, kSummaryWidth);
}

}  // namespace

std::string plan_table(const CalibrateResult& result) {
  if (result.plan.empty()) return {};
  return "\nThe next measurements; widths of the intervals after each, relative to the present "
         "ones\n\n" +
         plan_rows(result, "measure next");
}

std::string first_plan_words(const CalibrateResult& result) {
  if (result.plan.empty()) return "No measurement can be planned: the motor has no value at any.\n";
  std::string text =
      "The first measurements; widths of the intervals after each, relative to the ranges\n\n" +
      plan_rows(result, "measure") + "\nPlanned for the motor with";
  const char* comma = " ";
  for (const CalibrateResult::Estimate& e : result.estimates) {
    text += comma + e.parameter.name + " " + engineering(e.parameter.value, e.parameter.unit, 4);
    comma = ", ";
  }
  text += "; standard deviations assumed, 1 % of the largest value of each kind:";
  comma = " ";
  for (const CalibrateResult::ColumnScatter& one : result.columns) {
    text += comma + one.quantity + " " + engineering(one.deviation, one.unit, 3);
    comma = ", ";
  }
  return text +
         ".\nMeasure a few of them, name their table under 'data:', and run the study again: the "
         "plan then follows what was measured.\n";
}

}  // namespace twum::studies
