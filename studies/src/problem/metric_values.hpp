// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/metrics.hpp>
#include <twum/motors/expression.hpp>

#include <span>
#include <vector>

namespace twum::inline v0_1::studies {

/// Values of expressions, with derivatives in every parameter in use if `gradient`. A metric at a load that the motor
/// cannot carry is evaluated at kReachable times the largest torque, if there is one; one at a torque and a speed that the drive does
/// not hold at the wave that would (Y5.3).
/// @{
std::vector<MetricDerivative> metric_values(const Motor& motor,
                                            const ExpressionEvaluator& expressions, bool gradient,
                                            bool fixed_static_friction);
std::vector<MetricDerivative> metric_values(const Motor& motor,
                                            std::span<const MetricExpression> expressions,
                                            bool gradient, bool fixed_static_friction);
/// @}

/// Share of the largest torque that replaces a load that cannot be reached. It is close enough to lead a search back,
/// and far enough from the maximum for speed_at to have a derivative.
inline constexpr double kReachable = 0.999;

}  // namespace twum::inline v0_1::studies
