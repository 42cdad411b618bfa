// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "design/workspace.hpp"
#include "held/envelope.hpp"
#include "held/least_voltage.hpp"
#include "metrics/differentiator.hpp"
#include "metrics/wave_rows.hpp"

#include <twum/core/metrics.hpp>

#include <memory>
#include <optional>

namespace twum::inline v0_1::core {

/// True for what HeldMetrics answers: metrics at a torque and a speed, the envelope, and the reserve of a fixed drive.
constexpr bool is_held(const MetricRequest& request) {
  return request.argument == Argument::both || request.metric == Metric::held_speed_limit_at ||
         request.metric == Metric::held_torque_limit_at ||
         request.metric == Metric::voltage_reserve_at;
}

/// Metrics where the drive holds a torque at a speed (Y2.5): those of the motor under the held wave, at the speed. A wave
/// that several metrics need is found once.
class HeldMetrics {
 public:
  /// @param beyond_drive  what the drive cannot hold has the metrics of the nearest wave (Y5.3) in place of a status
  explicit HeldMetrics(const MotorDesign& design, bool beyond_drive = false)
      : design_(design), beyond_drive_(beyond_drive) {}

  MetricValue evaluate(const MetricRequest& request);
  /// With derivatives in all parameters (Y2.6).
  MetricDerivative differentiate(const MetricRequest& request, bool fixed_static_friction);

 private:
  /// A torque at a speed, and the motor under the wave that holds it.
  struct Known {
    double torque, speed;
    HeldPoint held;
    std::optional<Motor> motor;
  };
  const Known& known(double torque, double speed);
  /// Derivatives of a motor under its held wave.
  struct Slopes {
    const Known* of;
    bool fixed;
    std::unique_ptr<Differentiator> numbers;
    WaveRows rows;
  };
  Slopes& slopes(const Known& of, bool fixed);
  const Envelope& envelope();
  double value(const MetricRequest& request);
  MetricDerivative of_wave(const MetricRequest& request, const MetricValue& value, bool fixed);
  MetricDerivative of_envelope(const MetricRequest& request, const MetricValue& value, bool fixed);
  MetricDerivative of_drive_reserve(const MetricRequest& request, const MetricValue& value,
                                    bool fixed);
  struct VoltageAt {
    double voltage{0};
    Row slopes{};
    Smoothness smoothness{Smoothness::smooth};
  };
  const LeastVoltage& least_voltage(const MetricRequest& request);
  VoltageAt voltage_at(double torque, double speed, bool fixed);
  VoltageAt least_voltage_at(double torque, double near, bool fixed);
  MetricDerivative of_voltage_reserve(const MetricRequest& request, const MetricValue& value,
                                      bool fixed);
  MetricDerivative of_largest_torque(bool fixed);
  Envelope::Corner corner(const MetricRequest& request);

  const MotorDesign& design_;
  bool beyond_drive_;
  std::optional<Envelope> envelope_;
  struct KnownLeast {
    bool at_torque;
    double at;
    LeastVoltage found;
  };
  Deque<Known> known_;       // references stay valid
  Deque<KnownLeast> least_;  // likewise
  Deque<Slopes> slopes_;     // likewise
};

}  // namespace twum::inline v0_1::core
