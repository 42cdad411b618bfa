// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/namespaces.hpp>
#include <twum/core/parameters.hpp>
#include <twum/motors/expression.hpp>

#include <array>
#include <span>
#include <string_view>
#include <vector>

namespace twum::inline v0_1::motors {

/// A parameter that follows from others, such as contact_width from "0.15 * contact_radius".
struct DerivedParameter {
  Parameter parameter{};     ///< which one
  MetricExpression value{};  ///< expression of parameters only, with the dimension of `parameter`
};

/// Reads the expression from which a parameter follows.
/// @throws ValueError as parse_side(), for a metric in it, and for another dimension than the parameter's
DerivedParameter parse_derived(Parameter parameter, std::string_view text);

/// The parameters of variables of whatever kind, in their order.
template <typename Variable>
std::vector<Parameter> parameters_of(const std::vector<Variable>& variables) {
  std::vector<Parameter> parameters;
  for (const Variable& variable : variables) parameters.push_back(variable.parameter);
  return parameters;
}

/// The metrics followed by the derived parameters that are not among them, so that rows and reports show both.
std::vector<MetricExpression> with_derived(std::vector<MetricExpression> metrics,
                                           const std::vector<DerivedParameter>& derived);

/// The parameters that a study varies and those that follow from them. Makes designs from their values, and
/// derivatives with respect to the varied parameters. Immutable and thread-safe.
class VariedParameters {
 public:
  /// No varied parameters.
  VariedParameters() = default;
  /// @param base     design with all other values
  /// @param varied   in the order of their values
  /// @param derived  in any order
  /// @throws ValueError if a derived parameter or its alternative is varied or derived twice, or follows from itself
  VariedParameters(const MotorDesign& base, std::vector<Parameter> varied,
                   std::vector<DerivedParameter> derived);

  /// The varied parameters in the order of their values.
  const std::vector<Parameter>& varied() const noexcept { return varied_; }
  /// The derived parameters, each after those that it follows from.
  const std::vector<DerivedParameter>& derived() const noexcept { return derived_; }
  /// True if mu_0 does not follow mu in proportion, because it is varied or derived itself.
  bool fixed_static_friction() const noexcept { return fixed_static_friction_; }

  /// The base with these values [SI] of the varied parameters, and with the derived parameters that follow.
  /// @throws InputError as twum::with() for a value that is not admissible
  /// @throws EvaluationError such as "contact_width: out-of-range" for a derived parameter, "no-ring-mode" for a
  ///          plate without a suitable mode
  MotorDesign motor(std::span<const double> values) const;

  /// Derivatives of each derived parameter with respect to each varied one; SI.
  using Slopes = std::vector<std::vector<double>>;
  /// These derivatives at a design that motor() has made.
  Slopes slopes(const MotorDesign& design) const;
  /// Derivatives of a quantity with respect to the varied parameters while the derived ones follow, by the chain rule
  /// from its derivatives with respect to all parameters.
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

}  // namespace twum::inline v0_1::motors
