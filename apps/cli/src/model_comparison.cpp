// SPDX-License-Identifier: Apache-2.0
#include "model_comparison.hpp"

#include "text_table.hpp"

#include <twum/core/motor.hpp>
#include <twum/io/engineering.hpp>
#include <twum/io/number.hpp>
#include <twum/motors/settings.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace twum::inline v0_1::cli {
namespace {

std::string shown_metric(const MetricValue& value, const std::string& unit) {
  return value.status == MetricStatus::ok ? studies::engineering(value.value, unit)
                                          : std::string("- (") + to_string(value.status) + ")";
}

std::string change_text(const MetricValue& from, const MetricValue& to) {
  const bool known = from.status == MetricStatus::ok && to.status == MetricStatus::ok;
  if (!known || from.value == 0) return "-";
  constexpr double kRounding = 1e-6;  // error that `auto` allows
  const double change = to.value / from.value - 1;
  return std::abs(change) < kRounding ? "none" : studies::rounded_text(100 * change, 2) + " %";
}

// A name as a key.
std::string key_of(std::string name) {
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

ModelComparison compared(std::string heading, std::array<std::string, 2> names,
                         const MotorDesign& first, const MotorDesign& second) {
  ModelComparison comparison{
      std::move(heading), std::move(names), studies::plain_metrics(second), {}, 0};
  const Motor motor(second);
  const studies::ExpressionEvaluator evaluator(comparison.metrics);
  comparison.values = {evaluator.evaluate(Motor(first)), evaluator.evaluate(motor)};
  comparison.slices = motor.radial_slices();
  return comparison;
}

}  // namespace

ModelComparison compare_slices(const MotorDesign& design) {
  MotorDesign narrow = design, wide = design;
  narrow.stator.radial_slices = 1;
  if (design.stator.radial_slices == 1) wide.stator.radial_slices = kAutoSlices;
  return compared(
      "the contact at its mean radius (one slice) compared with the contact over its width",
      {"one slice", "track"}, narrow, wide);
}

ModelComparison compare_radial(const MotorDesign& design) {
  MotorDesign without = design, with_it = design;
  without.stator.radial_motion = false, with_it.stator.radial_motion = true;
  return compared(
      "surface motion along the track only (without) compared with additional radial motion (with)",
      {"without", "radial motion"}, without, with_it);
}

std::string comparison_text(const ModelComparison& comparison) {
  TextTable table{{{"metric", comparison.names[0], comparison.names[1], "change"}}};
  for (std::size_t i = 0; i < comparison.metrics.size(); ++i) {
    const std::string unit = comparison.metrics[i].unit();
    const MetricValue &first = comparison.values[0][i], &second = comparison.values[1][i];
    table.rows.push_back({comparison.metrics[i].text, shown_metric(first, unit),
                          shown_metric(second, unit), change_text(first, second)});
  }
  return comparison.heading + " (" + comparison.names[1] +
         ", radial_slices: " + studies::slices_text(comparison.slices) + ")\n" + aligned(table);
}

Json comparison_json(const ModelComparison& comparison) {
  Json json{{"slices", std::abs(comparison.slices)}};
  for (std::size_t k = 0; k < comparison.names.size(); ++k) {
    Json& values = json[key_of(comparison.names[k])] = Json::object();
    for (std::size_t i = 0; i < comparison.metrics.size(); ++i)
      values[comparison.metrics[i].text] = number_json(comparison.values[k][i].value);
  }
  return json;
}

}  // namespace twum::inline v0_1::cli
