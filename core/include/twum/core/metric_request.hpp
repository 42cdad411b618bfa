// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/load.hpp>
#include <twum/core/metric_value.hpp>

#include <optional>

namespace twum::inline v0_1 {

/// A metric and its argument in SI units: {Metric::torque_at, Argument::speed, 10.5}. A metric without an argument
/// ignores `at`. With Argument::none, speed_at reads `at` as a torque, every other metric as a speed. With Argument::both the
/// drive follows (held_point()).
struct MetricRequest {
  Metric metric{Metric::stall_torque};  ///< what is asked
  Argument argument{Argument::none};    ///< what `at` is
  double at{0};      ///< rotor speed [rad/s], load torque [N m], angle [rad] or a number of periods
  double torque{0};  ///< with Argument::both the load torque [N m], `at` the speed
  /// Asks for the metric of the motor at the steady temperatures of this point, with Argument::none at the mean temperatures of
  /// its operation; without it at the reference temperature.
  std::optional<LoadPoint> warm_at{};
  /// Asks for the metric of the motor at the end of its life under this load, with Argument::none under its operation.
  std::optional<LoadPoint> worn_at{};
  /// Asks for the temperature this long after the motor, at ambient temperature, took up the load [s], 0 or more; without it,
  /// or infinite, for the steady one. Metrics that are not `timed` (MetricInfo) ignore it.
  std::optional<double> after{};

  /// True if both ask the same.
  bool operator==(const MetricRequest&) const = default;
};

}  // namespace twum::inline v0_1
