// SPDX-License-Identifier: Apache-2.0
// Prints the change of two metrics for 1 % more of each parameter, from exact derivatives.
#include <twum/core.hpp>

#include <array>
#include <cstdio>

int main() {
  const twum::MotorDesign design;  // a 60 mm ring motor
  const std::array<twum::MetricRequest, 2> requests{{
      {twum::Metric::peak_power},
      {twum::Metric::torque_at, twum::Argument::speed, 12.5},
  }};
  const auto metrics = twum::differentiate(twum::Motor(design), requests);

  std::printf("%-24s %14s %14s\n", "+1 % of", "peak_power", "torque at 12.5");
  for (const twum::ParameterInfo& row : twum::parameter_table()) {
    if (!twum::in_use(design, row.parameter)) continue;
    std::printf("%-24s", std::string(row.name).c_str());
    for (const twum::MetricDerivative& metric : metrics) {
      const double change =
          0.01 * get(design, row.parameter) * metric.gradient[index_of(row.parameter)];
      std::printf(" %+13.3f%%", 100 * change / metric.value.value);
    }
    std::printf("\n");
  }
}
