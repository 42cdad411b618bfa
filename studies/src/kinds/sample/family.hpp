// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motor_design.hpp>
#include <twum/core/parameters.hpp>
#include <twum/io/column.hpp>

#include <optional>

/// What several kinds of study of one motor share: families over one parameter, loads; internal.
namespace twum::studies {

/// The motor with this value of the family's parameter.
/// @throws InputError naming the entry of the study, the value, and why there is no such motor
MotorDesign family_motor(const MotorDesign& base, Parameter parameter, double value);

/// A torque, a speed, or a torque held at a speed; none of them is no load.
std::optional<LoadPoint> load_point(const std::optional<double>& torque,
                                    const std::optional<double>& speed);

/// The column of the family's values.
StoredColumn family_column(Parameter parameter);

}  // namespace twum::studies
