// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motor_design.hpp>
#include <twum/core/parameters.hpp>
#include <twum/io/column.hpp>

/// Motors that differ in one parameter; internal.
namespace twum::studies {

/// The motor with this value of the family's parameter.
/// @throws InputError naming the entry of the study, the value, and why there is no such motor
MotorDesign family_motor(const MotorDesign& base, Parameter parameter, double value);

/// The column of the family's values.
StoredColumn family_column(Parameter parameter);

}  // namespace twum::studies
