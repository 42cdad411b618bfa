// SPDX-License-Identifier: Apache-2.0
#include "kinds/metric_gradients.hpp"

#include <algorithm>
#include <cstring>
#include <limits>
#include <utility>

namespace twum::studies {

MetricGradients::MetricGradients(const std::vector<MetricExpression>& metrics,
                                 std::vector<Parameter> variables)
    : evaluator_(metrics),
      variables_(std::move(variables)),
      fixed_static_friction_(std::find(variables_.begin(), variables_.end(),
                                       Parameter::static_friction) != variables_.end()) {}

std::vector<MetricGradients::Gradient> MetricGradients::at(const MotorDesign& design) const {
  std::vector<Gradient> result;
  for (const MetricDerivative& derivative :
       evaluator_.differentiate(Motor(design), fixed_static_friction_)) {
    Gradient gradient{{}, derivative.smoothness};
    if (derivative.value.status != MetricStatus::ok) gradient.smoothness = Smoothness::undefined;
    for (const Parameter variable : variables_) {
      gradient.values.push_back(gradient.smoothness == Smoothness::undefined
                                    ? std::numeric_limits<double>::quiet_NaN()
                                    : derivative.gradient[index_of(variable)]);
    }
    result.push_back(std::move(gradient));
  }
  return result;
}

std::string packed(std::span<const double> numbers) {
  std::string bytes(numbers.size_bytes(), '\0');
  if (!numbers.empty()) std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

std::vector<double> unpacked(std::string_view bytes) {
  std::vector<double> numbers(bytes.size() / sizeof(double));
  if (!numbers.empty())  // memcpy takes no null pointer, not even for nothing
    std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(double));
  return numbers;
}

}  // namespace twum::studies
