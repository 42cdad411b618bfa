// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/motors/expression.hpp>

namespace twum::motors {

using OwnTerm = std::shared_ptr<const OwnMetric>;

/// `undefined` where the program has no answer.
MetricValue own_value(const OwnMetric& own, const Motor& motor);
/// The same with derivatives; see ExpressionEvaluator::differentiate().
MetricDerivative own_derivative(const OwnMetric& own, const Motor& motor,
                                bool fixed_static_friction);

}  // namespace twum::motors
