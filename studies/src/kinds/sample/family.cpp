// SPDX-License-Identifier: Apache-2.0
#include "kinds/sample/family.hpp"

#include <twum/base/error.hpp>
#include <twum/base/no_value.hpp>
#include <twum/io/engineering.hpp>

namespace twum::inline v0_1::studies {

MotorDesign family_motor(const MotorDesign& base, Parameter parameter, double value) {
  try {
    MotorDesign motor = with(base, parameter, value);
    require_motor(motor);
    return motor;
  } catch (const InputError& error) {
    const ParameterInfo& row = info(parameter);
    throw InputError("study.family: " + std::string(row.name) + " = " +
                     engineering(value, row.unit) + " gives an invalid motor: " + error.what());
  }
}

std::vector<FamilyMotor> family_motors(const std::optional<CurveStudy::Family>& family,
                                       const MotorDesign& base) {
  if (!family) return {{kNoValue, base}};
  std::vector<FamilyMotor> motors;
  for (const double value : family->values)
    motors.push_back({value, family_motor(base, family->parameter, value)});
  return motors;
}

void require_load(const std::optional<LoadPoint>& load, const MotorDesign& motor) {
  if (!load && motor.operation.empty())
    throw InputError(
        "nothing loads the motor; give a torque, a speed, or both, or 'operation' in the motor "
        "file");
}

std::optional<LoadPoint> load_point(const std::optional<double>& torque,
                                    const std::optional<double>& speed) {
  if (torque && speed) return LoadPoint{Argument::both, *speed, *torque};
  if (torque) return LoadPoint{Argument::torque, *torque, 0};
  return speed ? std::optional(LoadPoint{Argument::speed, *speed, 0}) : std::nullopt;
}

StoredColumn family_column(Parameter parameter) {
  const ParameterInfo& row = info(parameter);
  return {std::string(row.name), std::string(row.unit)};
}

}  // namespace twum::inline v0_1::studies
