// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/design/parameters.hpp>
#include <twum/studies/metrics/expression.hpp>

#include <array>
#include <span>
#include <string_view>
#include <vector>

namespace twum::studies {

/// A parameter that follows from others, such as contact_width from "0.15 * contact_radius".
struct DerivedParameter {
  Parameter parameter{};   ///< which one
  MetricExpression value;  ///< of parameters alone, in the dimension of the parameter
};

/// Reads what a parameter follows from.
/// @throws ValueError as parse_side(), for a metric in it, and for another dimension than the parameter's
DerivedParameter parse_derived(Parameter parameter, std::string_view text);

/// The parameters of variables of whatever kind, in their order.
template <typename Variable>
std::vector<Parameter> parameters_of(const std::vector<Variable>& variables) {
  std::vector<Parameter> parameters;
  for (const Variable& variable : variables) parameters.push_back(variable.parameter);
  return parameters;
}

/// The metrics, and the derived parameters that are not among them, so that rows and reports show them.
std::vector<MetricExpression> with_derived(std::vector<MetricExpression> metrics,
                                           const std::vector<DerivedParameter>& derived);

/// The parameters that a study varies, and those that follow from them: designs of values, and derivatives by the varied
/// parameters. Constant, and safe from any number of threads.
class VariedParameters {
 public:
  /// None.
  VariedParameters() = default;
  /// @param base     what neither changes
  /// @param varied   in the order in which their values come
  /// @param derived  in any order
  /// @throws ValueError if a derived parameter or its twin is varied or derived twice, or follows from itself
  VariedParameters(const MotorDesign& base, std::vector<Parameter> varied,
                   std::vector<DerivedParameter> derived);

  /// In the order in which their values come.
  const std::vector<Parameter>& varied() const noexcept { return varied_; }
  /// Each after those that it follows from.
  const std::vector<DerivedParameter>& derived() const noexcept { return derived_; }
  /// True if mu_0 does not follow mu in proportion, because it is varied or derived itself.
  bool fixed_static_friction() const noexcept { return fixed_static_friction_; }

  /// The base with the values [SI] of the varied parameters, and what follows from them.
  /// @throws InputError as twum::with() for a value that is not admissible
  /// @throws EvaluationError "contact_width: out-of-range" or the like for a derived one, "no-ring-mode" for a plate without a wave
  MotorDesign motor(std::span<const double> values) const;

  /// Derivatives of each derived parameter by each varied one; SI.
  using Slopes = std::vector<std::vector<double>>;
  /// These derivatives at a design that motor() has made.
  Slopes slopes(const MotorDesign& design) const;
  /// Derivatives of a quantity by the varied parameters, those derived moving along: the chain rule on its derivatives by all
  /// parameters.
  std::vector<double> derivatives(const std::array<double, kParameterCount>& gradient,
                                  const Slopes& slopes) const;

 private:
  void refuse_twice() const;
  void put_in_order(const MotorDesign& base);

  MotorDesign base_{};
  std::vector<Parameter> varied_;
  std::vector<DerivedParameter> derived_;
  std::vector<ExpressionEvaluator> values_;  // one for each derived parameter
  bool fixed_static_friction_{false};
};

}  // namespace twum::studies
