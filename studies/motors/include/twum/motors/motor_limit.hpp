// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/namespaces.hpp>
#include <twum/motors/expression.hpp>

#include <limits>
#include <string>
#include <string_view>

namespace twum::inline v0_1::motors {

/// A limit on a quantity of a motor: "stall_torque >= 0.8 N.m", "thickness <= 0.2 * contact_half_length", "145 rpm <=
/// no_load_speed <= 155 rpm", "no_load_speed == 150 rpm +- 3 %".
struct MotorLimit {
  std::string text{};  ///< as typed, blanks trimmed
  /// quantity between the ends: one side, or left minus right if both sides depend on the motor
  MetricExpression metric{};
  double lower{-std::numeric_limits<double>::infinity()};  ///< SI
  double upper{std::numeric_limits<double>::infinity()};   ///< SI, >= lower
  /// The two sides if both depend on the motor, for reports; otherwise empty.
  std::vector<MetricExpression> sides{};
  /// Amount by which a search may break it and still keep it, SI; NaN: by the rule of the certificate (O2.1).
  double tolerance{std::numeric_limits<double>::quiet_NaN()};
  std::string tolerance_text{};  ///< the same as typed

  /// True if the value is between the ends; NaN is not.
  bool holds(double value) const { return value >= lower && value <= upper; }
  /// Distance of the value from the nearest end if it is outside, SI; 0 if it is between the ends, NaN for NaN.
  double excess(double value) const;
  /// True if the lower end is the relevant one: the only one, or the nearer one to the value.
  bool at_least(double value) const;
};

/// Reads a limit: two expressions of one dimension with ">=" or "<=" between them, a quantity on each side ("A <= EXPR <=
/// B"), or an equality with a tolerance ("EXPR == A +- B"), which in % is relative to A.
/// @throws ValueError with the position in the text, what was found and what would be right.
MotorLimit parse_limit(std::string_view text);

/// The limit with an own tolerance, a quantity of its dimension.
/// @throws ValueError with what was found and what would be right
MotorLimit with_tolerance(MotorLimit limit, std::string_view tolerance);

}  // namespace twum::inline v0_1::motors
