// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/metric_value.hpp>

#include <optional>

namespace twum::inline v0_1 {

/// A speed, a torque, or a torque that the drive holds at a speed; as the members of MetricRequest.
struct LoadPoint {
  Argument argument{Argument::torque};  ///< what `at` is
  double at{0};                         ///< rotor speed [rad/s] or load torque [N m]
  double torque{0};  ///< with Argument::both the load torque [N m], `at` the speed

  /// True if both are the same.
  bool operator==(const LoadPoint&) const = default;
};

/// A part of a cycle of loads.
struct LoadPhase {
  std::optional<LoadPoint> load{};  ///< without it the motor is off
  double time{0};                   ///< how long, more than 0 [s]
  /// Of the drive in this phase, more than 0 [V, rms]; without it that of the design. Of a design without a voltage not used.
  std::optional<double> voltage{};

  /// True if both are the same.
  bool operator==(const LoadPhase&) const = default;
};

}  // namespace twum::inline v0_1
