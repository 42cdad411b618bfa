// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motor_design.hpp>
#include <twum/core/parameters.hpp>
#include <twum/io/column.hpp>
#include <twum/studies/study.hpp>

#include <optional>
#include <vector>

/// What several kinds of study of one motor share: families over one parameter, loads; internal.
namespace twum::inline v0_1::studies {

/// The motor with this value of the family's parameter.
/// @throws InputError naming the entry of the study, the value, and why there is no such motor
MotorDesign family_motor(const MotorDesign& base, Parameter parameter, double value);

/// A motor, and its value of the family's parameter; NaN for the motor alone.
struct FamilyMotor {
  double value;
  MotorDesign design;
};
/// Those of a family, or the motor alone. @throws InputError as above
std::vector<FamilyMotor> family_motors(const std::optional<CurveStudy::Family>& family,
                                       const MotorDesign& base);

/// @throws InputError where neither a load is asked for nor the motor has an operation
void require_load(const std::optional<LoadPoint>& load, const MotorDesign& motor);

/// A torque, a speed, or a torque held at a speed; none of them is no load.
std::optional<LoadPoint> load_point(const std::optional<double>& torque,
                                    const std::optional<double>& speed);

/// The column of the family's values.
StoredColumn family_column(Parameter parameter);

}  // namespace twum::inline v0_1::studies
