// SPDX-License-Identifier: Apache-2.0
#include "results/calibration_tables.hpp"

#include <twum/studies/text/number.hpp>
#include <twum/studies/text/text_table.hpp>
#include <twum/studies/units/engineering.hpp>

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

// Percent of an estimate for 1 % of a held parameter.
double percent(const CalibrateResult& result, const CalibrateResult::Move& move, std::size_t j) {
  return move.slopes[j] * move.held.value / result.estimates[j].parameter.value;
}

// The largest of them; 0 where there is none.
double weight(const CalibrateResult& result, const CalibrateResult::Move& move) {
  double most = 0;
  for (std::size_t j = 0; j < move.slopes.size(); ++j) {
    const double size = std::fabs(percent(result, move, j));
    if (std::isfinite(size)) most = std::max(most, size);
  }
  return most;
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

std::string moves_table(const CalibrateResult& result) {
  constexpr std::size_t kMost = 6;   // summary.json and the page have all
  constexpr double kNotable = 0.01;  // percent
  std::vector<const CalibrateResult::Move*> order;
  for (const CalibrateResult::Move& move : result.moves)
    if (weight(result, move) >= kNotable) order.push_back(&move);
  if (order.empty()) return {};
  std::stable_sort(order.begin(), order.end(), [&](const auto* a, const auto* b) {
    return weight(result, *a) > weight(result, *b);
  });
  TextTable table;
  table.rows.push_back({"held fixed", "if it were"});
  for (const auto& e : result.estimates) table.rows[0].push_back(e.parameter.name);
  order.resize(std::min(order.size(), kMost));
  for (const CalibrateResult::Move* move : order) {
    const double value = 1.01 * move->held.value;
    table.rows.push_back({move->held.name + " " + engineering(move->held.value, move->held.unit, 4),
                          engineering(value, move->held.unit, 4)});
    for (std::size_t j = 0; j < move->slopes.size(); ++j) {
      const NamedValue& estimate = result.estimates[j].parameter;
      const double moved = estimate.value + move->slopes[j] * (value - move->held.value);
      table.rows.back().push_back(std::isfinite(moved) ? engineering(moved, estimate.unit) : "-");
    }
  }
  return "\nWhat the estimates would be with another value of what is held fixed\n\n" +
         aligned(table);
}

std::string plan_table(const CalibrateResult& result) {
  if (result.plan.empty()) return {};
  TextTable table;
  table.rows.push_back({"measure next", "all"});
  for (const auto& e : result.estimates) table.rows[0].push_back(e.parameter.name);
  for (const CalibrateResult::Planned& planned : result.plan) {
    const auto shown = [](double part) { return rounded_text(100 * part, 3) + " %"; };
    table.rows.push_back({reading_words(planned.point), shown(planned.mean)});
    for (const double width : planned.widths) table.rows.back().push_back(shown(width));
  }
  return "\nThe next measurements, and the widths of the intervals after each, in parts of those "
         "now\n\n" +
         aligned(table);
}

}  // namespace twum::studies
