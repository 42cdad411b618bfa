// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/performance/metrics.hpp>
#include <twum/studies/metrics/expression.hpp>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace twum::studies {

/// Exact derivatives of expressions by some parameters, the others held fixed (those that follow from
/// them move along). Constant, safe from any number of threads.
class MetricGradients {
 public:
  MetricGradients(const std::vector<MetricExpression>& metrics, std::vector<Parameter> variables);

  struct Gradient {
    std::vector<double> values;  ///< by each variable, SI; NaN: none
    Smoothness smoothness{Smoothness::smooth};
  };
  /// One for each metric.
  std::vector<Gradient> at(const MotorDesign& design) const;

 private:
  ExpressionEvaluator evaluator_;
  std::vector<Parameter> variables_;
  bool fixed_static_friction_;
};

/// Numbers as the bytes of a row's detail, and back.
std::string packed(std::span<const double> numbers);
std::vector<double> unpacked(std::string_view bytes);

}  // namespace twum::studies
