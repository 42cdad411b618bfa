// SPDX-License-Identifier: Apache-2.0
#include "datasheet/parts.hpp"

#include "telling/curve_charts.hpp"
#include "telling/load_parts.hpp"

#include <twum/core/life.hpp>
#include <twum/core/parameters.hpp>
#include <twum/motors/curve_points.hpp>
#include <twum/motors/expression.hpp>
#include <twum/motors/plain_name.hpp>
#include <twum/motors/reasons.hpp>
#include <twum/motors/settings.hpp>

#include <cmath>

namespace twum::studies::datasheet {
namespace {

std::string meaning_of(MetricStatus status) {
  for (const Reason& reason : reasons())
    if (reason.status == status) return reason.meaning;
  return to_string(status);
}

// The metrics of a motor but its life, which lifetime() has. A metric without a value has a line if the reason is informative, such as a motor that does
// not pull out, but not if it is undefined.
std::vector<Line> numbers_of(const Motor& motor, bool with_modes) {
  const std::vector<MetricExpression> metrics = plain_metrics(motor.design());
  const std::vector<MetricValue> values = ExpressionEvaluator(metrics).evaluate(motor);
  std::vector<Line> lines;
  for (std::size_t i = 0; i < metrics.size(); ++i) {
    const MetricInfo& row = info(metrics[i].request()->metric);
    if (row.needs_modes != with_modes || row.needs_wear ||
        values[i].status == MetricStatus::undefined)
      continue;
    const bool ok = values[i].status == MetricStatus::ok;
    lines.push_back({{plain_name(metrics[i].text)},
                     {ok ? shown(values[i].value, row.unit, row.name)
                         : telling::Part(meaning_of(values[i].status))}});
  }
  return lines;
}

}  // namespace

std::vector<Line> performance(const Motor& motor) {
  std::vector<Line> lines = numbers_of(motor, false);
  if (motor.design().operation.empty()) return lines;
  for (Line& line : lifetime(motor.design(), {})) lines.push_back(std::move(line));
  return lines;
}

std::vector<Line> electrical(const Motor& motor) { return numbers_of(motor, true); }

std::vector<Line> rated_point(const MotorDesign& design, const OperatingPoint& rated) {
  if (rated.status != PointStatus::ok) return {{{"no answer"}, {to_string(rated.status)}}};
  const telling::EfficiencyKind efficiency = telling::efficiency_kind(design);
  std::vector<Line> lines;
  for (const CurveColumn& column : curve_columns(design)) {
    const std::string_view name = column.name;
    const double value = column.value(rated);
    if (name == "contact_efficiency" || name == "overall_efficiency" || !std::isfinite(value))
      continue;
    lines.push_back({{plain_name(column.name)}, {shown(value, column.unit, name)}});
    if (name == "output_power" && std::isfinite(efficiency.value(rated)))
      lines.push_back({{efficiency.name}, {shown(efficiency.value(rated), "1", "efficiency")}});
  }
  for (Line& line : lifetime(design, LoadPoint{Argument::torque, rated.torque}))
    lines.push_back(std::move(line));
  return lines;
}

std::vector<Line> lifetime(const MotorDesign& design, const std::optional<LoadPoint>& load) {
  const telling::Phrase name{load ? "life at this load" : "life in the operation"};
  if (!design.wear) return {};
  if (design.stator.radial_slices == 1) return {{name, {"not known with one slice"}}};
  const Life found = load ? life(design, *load) : life(design);
  if (found.status != MetricStatus::ok) return {{name, {meaning_of(found.status)}}};
  const bool by_limit = found.end == EndOfLife::limit;
  return {{name, {telling::time_part(found.seconds)}},
          {{"revolutions until then"}, {shown(found.revolutions, "1")}},
          {{"end of the life"},
           telling::end_phrase(found.end, by_limit ? design.wear->until[found.limit].text : "")}};
}

std::vector<Line> parameters(const MotorDesign& design) {
  std::vector<Line> lines;
  for (const ParameterInfo& row : parameter_table()) {
    if (!in_use(design, row.parameter)) continue;
    const double value = get(design, row.parameter);
    const bool slices = row.parameter == Parameter::radial_slices;
    const std::string symbol = row.symbol.empty() ? "" : " " + std::string(row.symbol);
    lines.push_back(
        {{plain_name(std::string(row.name)) + symbol},
         {slices ? telling::Part(slices_text(static_cast<int>(value))) : shown(value, row.unit)}});
  }
  return lines;
}

}  // namespace twum::studies::datasheet
