// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/held_point.hpp>
#include <twum/core/metrics.hpp>

#include <deque>
#include <optional>

namespace twum::core {

/// Metrics where the drive holds a torque at a speed (Y2.5): those of the motor under the held wave, at the speed. A wave
/// that several metrics need is found once.
class HeldMetrics {
 public:
  explicit HeldMetrics(const MotorDesign& design) : design_(design) {}

  MetricValue evaluate(const MetricRequest& request);
  /// With derivatives in all parameters (Y2.6).
  MetricDerivative differentiate(const MetricRequest& request, bool fixed_static_friction);

 private:
  struct Known {
    double torque, speed;
    HeldPoint held;
    std::optional<Motor> motor;  ///< under the held wave
  };
  const Known& known(const MetricRequest& request);

  const MotorDesign& design_;
  std::deque<Known> known_;  // references stay valid
};

}  // namespace twum::core
