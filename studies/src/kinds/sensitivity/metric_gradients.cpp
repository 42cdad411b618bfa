// SPDX-License-Identifier: Apache-2.0
#include "kinds/sensitivity/metric_gradients.hpp"

#include <cstring>
#include <limits>
#include <utility>

namespace twum::inline v0_1::studies {

MetricGradients::MetricGradients(const std::vector<MetricExpression>& metrics,
                                 VariedParameters varied)
    : evaluator_(metrics), varied_(std::move(varied)) {}

std::vector<MetricGradients::Gradient> MetricGradients::at(std::span<const double> values) const {
  const MotorDesign design = varied_.motor(values);
  const auto slopes = varied_.slopes(design);
  std::vector<Gradient> result;
  for (const MetricDerivative& derivative :
       evaluator_.differentiate(Motor(design), varied_.fixed_static_friction())) {
    Gradient gradient{{}, derivative.smoothness};
    if (derivative.value.status != MetricStatus::ok) gradient.smoothness = Smoothness::undefined;
    const bool none = gradient.smoothness == Smoothness::undefined;
    gradient.values =
        none ? std::vector<double>(values.size(), std::numeric_limits<double>::quiet_NaN())
             : varied_.derivatives(derivative.gradient, slopes);
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

}  // namespace twum::inline v0_1::studies
