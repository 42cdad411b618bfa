// SPDX-License-Identifier: Apache-2.0
// A page asks for no temperatures and no lives, and is smaller without the search for them.
#include "metrics/heat_metrics.hpp"
#include "metrics/wear_metrics.hpp"

namespace twum::core {

MetricValue HeatMetrics::evaluate(const MetricRequest& /*request*/) {
  return {kNoValue, MetricStatus::undefined};
}

MetricDerivative HeatMetrics::differentiate(const MetricRequest& request, bool /*fixed*/) {
  return no_derivative(evaluate(request));
}

MetricValue WearMetrics::evaluate(const MetricRequest& /*request*/) {
  return {kNoValue, MetricStatus::undefined};
}

MetricDerivative WearMetrics::differentiate(const MetricRequest& request, bool /*fixed*/) {
  return no_derivative(evaluate(request));
}

}  // namespace twum::core
