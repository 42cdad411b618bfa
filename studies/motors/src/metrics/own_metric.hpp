// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/motors/expression.hpp>

#include <string_view>

namespace twum::inline v0_1::motors {

using OwnTerm = std::shared_ptr<const OwnMetric>;

/// The metrics of the program that are known on this thread; see KnownMetrics.
const OwnMetrics& known_metrics();
/// The one with this name; null if there is none.
OwnTerm find_known(std::string_view name);
/// Of the metric's unit.
/// @throws InputError if this is no SI unit
Dimension dimension_of_own(const OwnMetric& own);

/// `undefined` where the program has no answer.
MetricValue own_value(const OwnMetric& own, const Motor& motor);
/// The same with derivatives; see ExpressionEvaluator::differentiate().
MetricDerivative own_derivative(const OwnMetric& own, const Motor& motor,
                                bool fixed_static_friction);

}  // namespace twum::inline v0_1::motors
