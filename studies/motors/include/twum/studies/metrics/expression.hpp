// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/performance/metrics.hpp>
#include <twum/studies/formula/formula.hpp>

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace twum::studies {

/// What a name in an expression stands for: a metric ("stall_torque"), a point metric ("torque_at(100 rpm)",
/// "efficiency_at(0.5 N.m)"; the dimension tells speed from torque), or a parameter (its value is the design's own). In SI.
using Term = std::variant<MetricRequest, Parameter>;

/// What a study or table may ask of a motor: a term, or a formula of terms such as
/// "thickness / (2 * contact_half_length)" or "(peak_power - 5 W)^2".
struct MetricExpression {
  std::string text;         ///< of a term as typed, blanks trimmed; otherwise canonical
  Formula formula;          ///< of the values of its terms, in their order
  std::vector<Term> terms;  ///< each once

  /// SI unit of its value, "1" if dimensionless.
  std::string unit() const;
  /// The metric, if it is nothing else.
  const MetricRequest* request() const;
  /// The parameter, if it is nothing else.
  const Parameter* parameter() const;
};

/// The expression that is a parameter.
MetricExpression expression_of(Parameter parameter);

/// Reads one expression. A parameter that stands alone may go by the paper's symbol; in a formula a symbol such as `h` could
/// be a unit.
/// @throws ValueError with the position in the text, what was found and what would be right; also if there is no name in it.
MetricExpression parse_metric(std::string_view text);

/// Reads an expression that may be a mere quantity, such as one side of a limit.
/// @throws ValueError as parse_metric().
MetricExpression parse_side(std::string_view text);

/// Reads expressions between commas: "stall_torque, torque_at(100 rpm)".
/// @throws ValueError also if one is there twice or the list is empty.
std::vector<MetricExpression> parse_metric_list(std::string_view text);

/// Metrics without argument that have a meaning for a design, in the order of the metric table: those of the stator's modes
/// for one with modal data, and those that say where a given voltage stops to hold the wave for one with a voltage.
std::vector<MetricExpression> plain_metrics(const MotorDesign& design);

/// A parameter's value as a function of those in use, such as G = E / (2 (1 + nu)).
MetricDerivative parameter_value(const MotorDesign& design, Parameter parameter,
                                 bool fixed_static_friction);

/// Values of expressions for one motor, in their order. Metrics that several share are computed once.
/// Keep one evaluator for many motors; it is constant, and safe from any number of threads.
class ExpressionEvaluator {
 public:
  /// Of no expression.
  ExpressionEvaluator() = default;
  /// Of these expressions, which it copies.
  explicit ExpressionEvaluator(std::span<const MetricExpression> expressions);

  /// Costs what twum::evaluate() does, and throws as little: every value has a status, that of the first term without a
  /// value, or `undefined` where the formula has none, such as a quotient by zero.
  /// @param values  room for size() of them
  void evaluate(const Motor& motor, std::span<MetricValue> values) const;
  /// The same in a vector.
  std::vector<MetricValue> evaluate(const Motor& motor) const;
  /// With derivatives by every parameter, by the chain rule over those of twum::differentiate(), which also says what
  /// `fixed_static_friction` does. An expression at a kink of abs, min or max is one-sided.
  std::vector<MetricDerivative> differentiate(const Motor& motor, bool fixed_static_friction) const;

  /// How many expressions there are.
  std::size_t size() const noexcept { return asked_.size(); }
  /// The metrics that the expressions need, each once.
  std::span<const MetricRequest> requests() const noexcept { return requests_; }
  /// The expressions' values from those of requests().
  void combine(const MotorDesign& design, std::span<const MetricValue> metrics,
               std::span<MetricValue> values) const;
  /// Likewise with derivatives.
  std::vector<MetricDerivative> combine(const MotorDesign& design,
                                        std::span<const MetricDerivative> metrics,
                                        bool fixed_static_friction) const;

 private:
  using Place = std::variant<std::size_t, Parameter>;  // index into requests_, or a parameter
  struct Asked {
    Formula formula;
    std::vector<Place> places;  // of its terms
  };

  std::vector<MetricRequest> requests_;
  std::vector<Asked> asked_;
};

/// Which of these have no value and why, such as "stall_torque: no-periodic-state; ..."; empty if all have one.
/// @param values  of the expressions, in their order
std::string unanswered(std::span<const MetricExpression> expressions,
                       std::span<const MetricValue> values);

}  // namespace twum::studies
