// SPDX-License-Identifier: Apache-2.0
#include "without_value.hpp"

#include <twum/core/motor.hpp>

#include <algorithm>

namespace twum::inline v0_1::motion {

double value_or_reason(const MetricValue& found) {
  if (found.status != MetricStatus::ok) throw WithoutValue{found.status};
  return found.value;
}

void require_running(const MotorDesign& design, double torque) {
  const Motor motor(design);
  if (!(motor.holding_torque() > 0)) throw WithoutValue{MetricStatus::undefined};
  const double friction = design.load.value_or(ShaftLoad{}).friction;
  value_or_reason(twum::evaluate(
      motor, {Metric::speed_at, Argument::torque, std::max(torque + friction, 0.0)}));
}

}  // namespace twum::inline v0_1::motion
