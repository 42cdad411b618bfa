// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/performance/metrics.hpp>
#include <twum/studies/metrics/expression.hpp>

#include <span>
#include <vector>

namespace twum::studies {

/// Values of expressions, metrics or parameters, with derivatives in every parameter in use if
/// `gradient`. Equal requests are answered once. A metric asked at a load that the motor cannot carry
/// is taken at kReachable times the largest torque, if it has one.
std::vector<MetricDerivative> metric_values(const Motor& motor,
                                            std::span<const MetricExpression> expressions,
                                            bool gradient, bool fixed_static_friction);

/// Share of the largest torque that stands for a load out of reach: near enough to lead back into
/// reach, far enough from the maximum for speed_at to have a slope.
inline constexpr double kReachable = 0.999;

/// A parameter's value as a function of those in use, such as G = E / (2 (1 + nu)).
MetricDerivative parameter_value(const MotorDesign& design, Parameter parameter,
                                 bool fixed_static_friction);

}  // namespace twum::studies
