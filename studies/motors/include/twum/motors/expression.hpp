// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/namespaces.hpp>
#include <twum/core/metrics.hpp>
#include <twum/io/formula.hpp>

#include <array>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace twum::inline v0_1::motors {

/// A quantity that a program computes from a motor, such as its cost. Its functions have to be pure and thread-safe. For a
/// motor without an answer they throw EvaluationError, or return NaN.
struct OwnMetric {
  std::string name{};     ///< its name in answers: letters, digits and '_', a letter first
  std::string unit{"1"};  ///< SI unit of its value
  std::function<double(const Motor& motor)> value{};  ///< its value
  /// Its derivatives with respect to every parameter, as MetricDerivative::gradient has them where mu_0 keeps its ratio to
  /// mu. Empty: it has none; then a search needs a solver without gradients and gives no certificate.
  std::function<std::array<double, kParameterCount>(const Motor& motor)> gradient{};
};

/// A name in an expression: a metric ("stall_torque"), a point metric ("torque_at(100 rpm)", "efficiency_at(0.5
/// N.m)"; the dimension says whether it is a speed or a torque), a parameter of the design, or a program's own metric. In SI.
/// "warm(speed_at(0.5 N.m))" is a metric at the steady temperatures of its own point, "warm(stall_torque, 0.5 N.m)" at those of the
/// point that is named.
using Term = std::variant<MetricRequest, Parameter, std::shared_ptr<const OwnMetric>>;

/// A quantity of a motor that a study or table can ask for: a term, or a formula of terms such as "thickness / (2 *
/// contact_half_length)" or "(peak_power - 5 W)^2".
struct MetricExpression {
  /// a single term as typed, without blanks at its ends; otherwise the canonical text
  std::string text;
  Formula formula;          ///< function of the values of its terms, in their order
  std::vector<Term> terms;  ///< each once

  /// SI unit of its value, "1" if dimensionless.
  std::string unit() const;
  /// The metric, if the expression is a single metric; otherwise null.
  const MetricRequest* request() const;
  /// The parameter, if the expression is a single parameter; otherwise null.
  const Parameter* parameter() const;
  /// False if a term is an OwnMetric without a gradient.
  bool has_derivatives() const;
};

/// True for a metric or a parameter alone that is an absolute temperature, which people read in degC.
bool is_absolute(const MetricExpression& expression);

/// The expression for a single parameter.
MetricExpression expression_of(Parameter parameter);
/// The expression for a program's own metric.
/// @throws InputError for a name that is none or that of a metric or parameter, an unknown unit, and without a value
MetricExpression expression_of(OwnMetric metric);

/// Metrics of a program, shared by the expressions that use them.
using OwnMetrics = std::vector<std::shared_ptr<const OwnMetric>>;

/// As long as it lives, parse_metric() and what reads limits and studies know metrics of the program by their names, on this
/// thread:
///
///     const KnownMetrics known({cost});
///     study.objective = {parse_metric("stall_torque / cost"), true};
///     study.constraints = {parse_limit("cost <= 12")};
class KnownMetrics {
 public:
  /// In addition to those that are known already; of equal names the newest counts.
  /// @throws InputError as expression_of()
  explicit KnownMetrics(const std::vector<OwnMetric>& metrics);
  /// The same for metrics that expressions hold.
  explicit KnownMetrics(OwnMetrics metrics);
  ~KnownMetrics();
  KnownMetrics(const KnownMetrics&) = delete;
  KnownMetrics& operator=(const KnownMetrics&) = delete;

 private:
  OwnMetrics before_;
};

/// Reads one expression. A single parameter may be given by its symbol; in a formula it may not, because a symbol
/// such as `h` could be a unit.
/// @throws ValueError with the position in the text, what was found and what would be right; also if it contains no
///          name.
MetricExpression parse_metric(std::string_view text);

/// Reads an expression that may also be a constant quantity, such as one side of a limit.
/// @throws ValueError as parse_metric().
MetricExpression parse_side(std::string_view text);

/// Reads expressions between commas: "stall_torque, torque_at(100 rpm)".
/// @throws ValueError as parse_metric(), and if an expression occurs twice or the list is empty.
std::vector<MetricExpression> parse_metric_list(std::string_view text);

/// Metrics without argument that are defined for a design, in the order of the metric table. Metrics of the stator's
/// modes need modal data; metrics that say where a voltage no longer maintains the wave need a voltage.
std::vector<MetricExpression> plain_metrics(const MotorDesign& design);

/// A parameter's value as a function of those in use, such as G = E / (2 (1 + nu)).
MetricDerivative parameter_value(const MotorDesign& design, Parameter parameter,
                                 bool fixed_static_friction);

/// Computes the values of expressions for a motor, in their order. Metrics that several expressions share are
/// computed once. Use one evaluator for many motors; it is immutable and thread-safe.
class ExpressionEvaluator {
 public:
  /// Without expressions.
  ExpressionEvaluator() = default;
  /// For these expressions, which are copied.
  explicit ExpressionEvaluator(std::span<const MetricExpression> expressions);

  /// Costs as much as twum::evaluate(), and no value makes it throw. A value has the status of the first term without
  /// a value, or `undefined` where the formula is not defined, such as for a division by zero.
  /// @param values  room for size() values
  void evaluate(const Motor& motor, std::span<MetricValue> values) const;
  /// The same in a vector.
  std::vector<MetricValue> evaluate(const Motor& motor) const;
  /// The same with derivatives with respect to every parameter, from twum::differentiate() by the chain rule; see
  /// there for `fixed_static_friction`. An expression at a kink of abs, min or max is one-sided.
  std::vector<MetricDerivative> differentiate(const Motor& motor, bool fixed_static_friction) const;

  /// Number of expressions.
  std::size_t size() const noexcept { return asked_.size(); }
  /// The metrics that the expressions need, each once.
  std::span<const MetricRequest> requests() const noexcept { return requests_; }
  /// Values of the expressions from the values of requests().
  void combine(const Motor& motor, std::span<const MetricValue> metrics,
               std::span<MetricValue> values) const;
  /// Likewise with derivatives.
  std::vector<MetricDerivative> combine(const Motor& motor,
                                        std::span<const MetricDerivative> metrics,
                                        bool fixed_static_friction) const;
  /// Values of expressions of parameters alone.
  void combine(const MotorDesign& design, std::span<MetricValue> values) const;
  /// Likewise with derivatives.
  std::vector<MetricDerivative> combine(const MotorDesign& design,
                                        bool fixed_static_friction) const;

 private:
  // Index into requests_, a parameter, or a program's own metric.
  using Place = std::variant<std::size_t, Parameter, std::shared_ptr<const OwnMetric>>;
  struct Asked {
    Formula formula;
    std::vector<Place> places;  // of its terms
  };
  template <typename Value, typename Find, typename Combine>
  void combine_terms(const Find& find, const Combine& combine) const;

  std::vector<MetricRequest> requests_;
  std::vector<Asked> asked_;
};

/// Names the expressions without a value and why, such as "stall_torque: no-periodic-state; ..."; empty if all have
/// one.
/// @param values  of the expressions, in their order
std::string unanswered(std::span<const MetricExpression> expressions,
                       std::span<const MetricValue> values);
/// The same with the expressions whose value has no end, such as "on_time_at(0.5 N.m): never-too-hot": each that has no number.
std::string without_number(std::span<const MetricExpression> expressions,
                           std::span<const MetricValue> values);

}  // namespace twum::inline v0_1::motors
