// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/performance/metrics.hpp>

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace twum::studies {

/// What a study or table may ask of a motor: a metric ("stall_torque"), a point metric
/// ("torque_at(100 rpm)", "efficiency_at(0.5 N.m)"; the dimension tells speed from torque), or a
/// parameter ("preload"; its value is the design's own).
struct MetricExpression {
  std::string text;                             ///< as typed, blanks trimmed
  std::variant<MetricRequest, Parameter> what;  ///< in SI

  /// SI unit of its value, "1" if dimensionless.
  std::string_view unit() const;
};

/// Reads one expression; parameters may go by the paper's symbols.
/// @throws ValueError with the position in the text, what was found and what would be right.
MetricExpression parse_metric(std::string_view text);

/// Reads expressions between commas: "stall_torque, torque_at(100 rpm)".
/// @throws ValueError also if one is there twice or the list is empty.
std::vector<MetricExpression> parse_metric_list(std::string_view text);

/// Metrics without argument, in the order of the metric table.
std::vector<MetricExpression> plain_metrics();

/// Values of expressions for one motor, in their order. Work that several share is done once.
/// Keep one evaluator for many motors; it is constant, and safe from any number of threads.
class ExpressionEvaluator {
 public:
  /// Of these expressions, which it copies.
  explicit ExpressionEvaluator(std::span<const MetricExpression> expressions);
  /// Costs what twum::evaluate() does, and throws as little: every value has a status.
  /// @param values  room for size() of them
  void evaluate(const Motor& motor, std::span<MetricValue> values) const;
  /// The same in a vector.
  std::vector<MetricValue> evaluate(const Motor& motor) const;
  /// How many expressions there are.
  std::size_t size() const noexcept { return places_.size(); }

 private:
  std::vector<MetricRequest> requests_;
  std::vector<std::variant<std::size_t, Parameter>>
      places_;  // index into requests_, or a parameter
};

/// Which of these have no value and why, such as "stall_torque: no-periodic-state; ..."; empty if all have one.
/// @param values  of the expressions, in their order
std::string unanswered(std::span<const MetricExpression> expressions,
                       std::span<const MetricValue> values);

}  // namespace twum::studies
