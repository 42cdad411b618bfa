// SPDX-License-Identifier: Apache-2.0
#include "problem/metric_values.hpp"

namespace twum::studies {
namespace {

std::vector<MetricDerivative> with_gradients(const Motor& motor,
                                             const ExpressionEvaluator& expressions, bool fixed) {
  const auto requests = expressions.requests();
  std::vector<MetricDerivative> answers = differentiate(motor, requests, fixed);
  for (std::size_t i = 0; i < answers.size(); ++i) {
    if (answers[i].value.status == MetricStatus::unreachable)
      answers[i] = differentiate_at_share(motor, requests[i].metric, kReachable, fixed);
  }
  return expressions.combine(motor.design(), answers, fixed);
}

std::vector<MetricDerivative> without_gradients(const Motor& motor,
                                                const ExpressionEvaluator& expressions) {
  const auto requests = expressions.requests();
  std::vector<MetricValue> answers = evaluate(motor, requests);
  for (std::size_t i = 0; i < answers.size(); ++i) {
    if (answers[i].status == MetricStatus::unreachable)
      answers[i] = evaluate_at_share(motor, requests[i].metric, kReachable);
  }
  std::vector<MetricValue> values(expressions.size());
  expressions.combine(motor.design(), answers, values);
  std::vector<MetricDerivative> list;
  for (const MetricValue& value : values) list.push_back({value, {}, Smoothness::smooth});
  return list;
}

}  // namespace

std::vector<MetricDerivative> metric_values(const Motor& motor,
                                            const ExpressionEvaluator& expressions, bool gradient,
                                            bool fixed_static_friction) {
  return gradient ? with_gradients(motor, expressions, fixed_static_friction)
                  : without_gradients(motor, expressions);
}

std::vector<MetricDerivative> metric_values(const Motor& motor,
                                            std::span<const MetricExpression> expressions,
                                            bool gradient, bool fixed_static_friction) {
  return metric_values(motor, ExpressionEvaluator(expressions), gradient, fixed_static_friction);
}

}  // namespace twum::studies
