// SPDX-License-Identifier: Apache-2.0
// A page asks for no temperatures, and is smaller without the search for them.
#include "metrics/heat_metrics.hpp"

namespace twum::core {

MetricValue HeatMetrics::evaluate(const MetricRequest& /*request*/) {
  return {kNoValue, MetricStatus::undefined};
}

MetricDerivative HeatMetrics::differentiate(const MetricRequest& request, bool /*fixed*/) {
  return no_derivative(evaluate(request));
}

}  // namespace twum::core
