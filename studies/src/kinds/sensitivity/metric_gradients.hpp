// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/metrics.hpp>
#include <twum/motors/expression.hpp>
#include <twum/motors/varied_parameters.hpp>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace twum::inline v0_1::studies {

/// Exact derivatives of expressions with respect to the varied parameters, with the others fixed and the derived ones
/// following. Immutable and thread-safe.
class MetricGradients {
 public:
  MetricGradients(const std::vector<MetricExpression>& metrics, VariedParameters varied);

  struct Gradient {
    std::vector<double> values;  ///< by each variable, SI; NaN: none
    Smoothness smoothness{Smoothness::smooth};
  };
  /// One for each metric, at values of the variables.
  /// @throws InputError, EvaluationError as VariedParameters::motor()
  std::vector<Gradient> at(std::span<const double> values) const;

 private:
  ExpressionEvaluator evaluator_;
  VariedParameters varied_;
};

/// Numbers as the bytes of a row's detail, and back.
std::string packed(std::span<const double> numbers);
std::vector<double> unpacked(std::string_view bytes);

}  // namespace twum::inline v0_1::studies
