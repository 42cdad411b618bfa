// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/design/motor_design.hpp>
#include <twum/studies/metrics/expression.hpp>

#include <span>
#include <string>

namespace twum::studies {

/// Values of expressions for a motor.
/// @param evaluator  of these metrics
/// @param values     as many as there are metrics; NaN where there is none
/// @return why there is no full answer, such as "stall_torque: no-periodic-state"; empty if there is
/// @throws InputError for values that no motor can have
std::string evaluate_design(const MotorDesign& design, std::span<const MetricExpression> metrics,
                            const ExpressionEvaluator& evaluator, std::span<MetricValue> values);

}  // namespace twum::studies
