// SPDX-License-Identifier: Apache-2.0
#include "problem/metric_values.hpp"

#include <twum/motion/manoeuvres.hpp>  // gives the program metrics of motions

namespace twum::inline v0_1::studies {
namespace {

// A torque that the drive does not hold at a speed.
bool beyond_drive(const MetricRequest& request, MetricStatus status) {
  if (request.argument != Argument::both) return false;
  switch (status) {
    case MetricStatus::torque_out_of_reach:
    case MetricStatus::voltage_too_low:
    case MetricStatus::amplitude_too_low:
    case MetricStatus::outside_frequency_range:
    case MetricStatus::unstable_amplitude: return true;
    default: return false;
  }
}

// Temperatures, lives, motions, and metrics of the warm or worn motor have no value where the cold motor does not carry the load.
bool has_value_nearby(const MetricRequest& request) {
  const MetricInfo& row = info(request.metric);
  return !request.warm_at && !request.worn_at && !row.needs_thermal && !row.needs_wear &&
         !row.needs_motion;
}

std::vector<MetricDerivative> with_gradients(const Motor& motor,
                                             const ExpressionEvaluator& expressions, bool fixed) {
  const auto requests = expressions.requests();
  std::vector<MetricDerivative> answers = differentiate(motor, requests, fixed);
  for (std::size_t i = 0; i < answers.size(); ++i) {
    if (!has_value_nearby(requests[i])) continue;
    if (answers[i].value.status == MetricStatus::unreachable)
      answers[i] = differentiate_at_share(motor, requests[i].metric, kReachable, fixed);
    if (beyond_drive(requests[i], answers[i].value.status))
      answers[i] = differentiate_beyond_drive(motor, requests[i], fixed);
  }
  return expressions.combine(motor, answers, fixed);
}

std::vector<MetricDerivative> without_gradients(const Motor& motor,
                                                const ExpressionEvaluator& expressions) {
  const auto requests = expressions.requests();
  std::vector<MetricValue> answers = evaluate(motor, requests);
  for (std::size_t i = 0; i < answers.size(); ++i) {
    if (!has_value_nearby(requests[i])) continue;
    if (answers[i].status == MetricStatus::unreachable)
      answers[i] = evaluate_at_share(motor, requests[i].metric, kReachable);
    if (beyond_drive(requests[i], answers[i].status))
      answers[i] = evaluate_beyond_drive(motor, requests[i]);
  }
  std::vector<MetricValue> values(expressions.size());
  expressions.combine(motor, answers, values);
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

}  // namespace twum::inline v0_1::studies
