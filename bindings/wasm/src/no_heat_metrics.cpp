// SPDX-License-Identifier: Apache-2.0
// A page asks for no temperatures and no lives, and is smaller without the search for them.
#include "design/stator_heat.hpp"
#include "metrics/heat_metrics.hpp"
#include "metrics/wear_metrics.hpp"

namespace twum::inline v0_1 {

double stator_housing_conductance(const MotorDesign& design) {
  return design.thermal ? design.thermal->conductances.stator_housing.value_or(kNoValue) : kNoValue;
}
double stator_contact_conductance(const MotorDesign& design) {
  return design.thermal ? design.thermal->conductances.stator_contact.value_or(kNoValue) : kNoValue;
}
double stator_heat_capacity(const MotorDesign& design) {
  return design.thermal ? design.thermal->stator.heat_capacity.value_or(kNoValue) : kNoValue;
}
void add_stator_heat(const MotorDesign& /*given*/, ParameterArray<Dual<double, 1>>& /*values*/) {}

}  // namespace twum::inline v0_1

namespace twum::inline v0_1::core {

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

}  // namespace twum::inline v0_1::core
