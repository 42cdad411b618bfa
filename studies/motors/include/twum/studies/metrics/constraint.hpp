// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/metrics/expression.hpp>

#include <string>
#include <string_view>

namespace twum::studies {

/// A limit on what a motor does: "stall_torque >= 0.8 N.m", "wear_intensity_at(80 rpm) <= 5 kW/m^2".
struct Constraint {
  std::string text;         ///< as typed, blanks trimmed
  MetricExpression metric;  ///< what is limited
  bool at_least;            ///< ">=", otherwise "<="
  double limit;             ///< in the metric's SI unit
};

/// Reads a limit: a metric or parameter, "<=" or ">=", and a quantity of its dimension.
/// @throws ValueError with the position in the text, what was found and what would be right.
Constraint parse_constraint(std::string_view text);

}  // namespace twum::studies
