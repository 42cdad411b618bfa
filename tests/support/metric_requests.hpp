// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/design/motor_design.hpp>
#include <twum/core/performance/metrics.hpp>
#include <twum/core/performance/motor.hpp>

#include <vector>

namespace twum::test {

/// Every metric once, those at a speed or a torque [SI] there; those at either at both.
inline std::vector<MetricRequest> every_metric(double speed, double torque) {
  std::vector<MetricRequest> list;
  for (const MetricInfo& row : metric_table()) {
    const bool either = row.argument == Argument::speed_or_torque;
    if (row.argument == Argument::none) list.push_back({row.metric});
    if (either || row.argument == Argument::speed)
      list.push_back({row.metric, Argument::speed, speed});
    if (either || row.argument == Argument::torque)
      list.push_back({row.metric, Argument::torque, torque});
  }
  return list;
}

/// Their values at a design; NaN where there is none.
inline std::vector<double> values_of(const MotorDesign& design,
                                     const std::vector<MetricRequest>& asked) {
  std::vector<double> list;
  for (const MetricValue& v : evaluate(Motor(design), asked)) list.push_back(v.value);
  return list;
}

}  // namespace twum::test
