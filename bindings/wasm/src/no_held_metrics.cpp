// SPDX-License-Identifier: Apache-2.0
// A page asks for no metric at a torque and a speed together, and is smaller without the search for them.
#include "metrics/held_metrics.hpp"

#include <twum/base/no_value.hpp>

namespace twum::inline v0_1::core {

MetricValue HeldMetrics::evaluate(const MetricRequest& /*request*/) {
  return {kNoValue, MetricStatus::undefined};
}

MetricDerivative HeldMetrics::differentiate(const MetricRequest& request, bool /*fixed*/) {
  MetricDerivative none{evaluate(request), {}, Smoothness::undefined};
  none.gradient.fill(kNoValue);
  return none;
}

}  // namespace twum::inline v0_1::core
