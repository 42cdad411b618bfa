// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/metrics/evaluate_design.hpp>

#include <twum/base/error.hpp>

#include <algorithm>
#include <limits>

namespace twum::studies {

std::string evaluate_design(const MotorDesign& design, std::span<const MetricExpression> metrics,
                            const ExpressionEvaluator& evaluator, std::span<MetricValue> values) {
  constexpr MetricValue kNone{std::numeric_limits<double>::quiet_NaN(), MetricStatus::undefined};
  std::fill(values.begin(), values.end(), kNone);
  try {
    evaluator.evaluate(Motor(design), values);
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& error) {
    return error.what();
  }
  std::string reason;
  for (std::size_t i = 0; i < metrics.size(); ++i) {
    if (values[i].status == MetricStatus::ok) continue;
    reason += (reason.empty() ? "" : "; ") + metrics[i].text + ": " + to_string(values[i].status);
  }
  return reason;
}

}  // namespace twum::studies
