// SPDX-License-Identifier: Apache-2.0
#include "slice_comparison.hpp"

#include "text_table.hpp"

#include <twum/core/motor.hpp>
#include <twum/io/engineering.hpp>
#include <twum/io/number.hpp>
#include <twum/motors/settings.hpp>

#include <cmath>
#include <cstdlib>

namespace twum::cli {
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

Json values_json(const SliceComparison& comparison, const std::vector<MetricValue>& values) {
  Json json = Json::object();
  for (std::size_t i = 0; i < values.size(); ++i)
    json[comparison.metrics[i].text] = number_json(values[i].value);
  return json;
}

}  // namespace

SliceComparison compare_slices(const MotorDesign& design) {
  MotorDesign narrow = design, wide = design;
  narrow.stator.radial_slices = 1;
  if (design.stator.radial_slices == 1) wide.stator.radial_slices = kAutoSlices;
  const Motor track(wide);
  const auto metrics = studies::plain_metrics(design);
  const studies::ExpressionEvaluator evaluator(metrics);
  return {metrics, evaluator.evaluate(Motor(narrow)), evaluator.evaluate(track),
          track.radial_slices()};
}

std::string comparison_text(const SliceComparison& comparison) {
  TextTable table{{{"metric", "one slice", "track", "change"}}};
  for (std::size_t i = 0; i < comparison.metrics.size(); ++i) {
    const std::string unit = comparison.metrics[i].unit();
    const MetricValue &one = comparison.one_slice[i], &track = comparison.track[i];
    table.rows.push_back({comparison.metrics[i].text, shown_metric(one, unit),
                          shown_metric(track, unit), change_text(one, track)});
  }
  return "the contact at its mean radius (one slice) against its width (track, radial_slices: " +
         studies::slices_text(comparison.slices) + ")\n" + aligned(table);
}

Json comparison_json(const SliceComparison& comparison) {
  return {{"slices", std::abs(comparison.slices)},
          {"one_slice", values_json(comparison, comparison.one_slice)},
          {"track", values_json(comparison, comparison.track)}};
}

}  // namespace twum::cli
