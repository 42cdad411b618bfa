// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/motor_problem.hpp>

#include <optional>
#include <vector>

namespace twum::inline v0_1::studies {

/// Next to the voltage at which the running wave ends, metrics change with the square root of what is left: a search asks for this
/// reserve.
inline constexpr double kLeastVoltageReserve = 2e-3;

/// What goals and limits are about, in their order.
std::vector<MetricExpression> asked(const DesignProblem& problem);

/// A limit that follows from the metrics and variables of a question.
struct ImpliedLimit {
  MotorLimit limit;
  /// What has no value beyond it: metrics with this argument. Nothing: it orders the coefficients of friction, mu_0 >= mu.
  std::optional<MetricRequest> argument{};
  /// Where that has a value at last; nothing: up to the limit.
  std::optional<double> ends_at{};

  double end() const { return ends_at.value_or(limit.lower); }
  bool orders_friction() const { return !argument; }
  /// True if it asks for the voltage with which a drive of fixed frequency runs the motor.
  bool is_of_fixed_drive() const;
  /// True if an expression has no value beyond it.
  bool is_about(const MetricExpression& metric) const;
};

/// The largest torque of each load; the limits that end a life, for the new motor; the voltage with which a drive of fixed frequency
/// carries each load, or runs at each speed (Y5.4); the reserves of each torque held at a speed (Y5.1, Y5.2); the order of the
/// coefficients of friction last.
std::vector<ImpliedLimit> implied_limits(const DesignProblem& problem);

}  // namespace twum::inline v0_1::studies
