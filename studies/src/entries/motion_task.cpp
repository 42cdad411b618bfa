// SPDX-License-Identifier: Apache-2.0
#include "entries/motion_task.hpp"

#include <twum/base/no_value.hpp>
#include <twum/core/parameters.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace twum::inline v0_1::studies {

double MotionStudy::step() const { return output.step.value_or(duration / 1000); }

MotorDesign motion_motor(const MotionStudy& asked, const MotorDesign& motor) {
  using P = Parameter;
  std::vector<ParameterValue> values;
  const auto put = [&](Parameter parameter, const std::optional<double>& value) {
    if (value) values.emplace_back(parameter, *value);
  };
  const MotionStudy::Load& load = asked.load;
  put(P::load_inertia, load.inertia), put(P::load_damping, load.damping);
  put(P::load_friction, load.friction), put(P::load_stiffness, load.stiffness);
  put(P::load_neutral, load.neutral);
  return with(motor, values);
}

std::vector<double> motion_times(const MotionStudy& asked) {
  std::vector<double> times;
  const double share = asked.duration / asked.step() * (1 + 1e-12);  // the end belongs to them
  for (std::uint64_t k = 0; k <= static_cast<std::uint64_t>(share); ++k)
    times.push_back(std::min(static_cast<double>(k) * asked.step(), asked.duration));
  return times;
}

motion::Actuator MotionControl::actuator_of(const MotorDesign& motor) const {
  if (kind == Kind::position) return motion::Actuator::frequency;
  const bool by_voltage = motor.stator.control == DriveControl::voltage;
  return actuator.value_or(by_voltage ? motion::Actuator::voltage : motion::Actuator::frequency);
}

motion::SpeedControl speed_control(const MotionControl& asked, const MotorDesign& motor) {
  motion::SpeedControl control;
  control.reference = asked.reference, control.sample_time = asked.sample_time;
  control.delay = static_cast<int>(asked.delay);
  if (asked.encoder) control.encoder = static_cast<double>(*asked.encoder);
  control.actuator = asked.actuator_of(motor);
  const bool by_voltage = control.actuator == motion::Actuator::voltage;
  if (asked.range.size() == 2)
    control.range = {asked.range[0].value, asked.range[1].value};
  else
    control.range = by_voltage
                        ? std::pair{kNoValue, kNoValue}
                        : motor.stator.frequency_range.value_or(std::pair{kNoValue, kNoValue});
  const auto [least, most] = control.range;
  control.start = by_voltage ? asked.start_voltage.value_or(motor.stator.voltage.value_or(kNoValue))
                             : asked.start_frequency.value_or(most);
  if (asked.slew) control.slew = asked.slew->value;
  if (asked.gains) control.gains = motion::LoopGains{asked.gains->kp.value, asked.gains->ki.value};
  return control;
}

motion::PositionControl position_control(const MotionControl& asked, const MotorDesign& motor) {
  const motion::SpeedControl common = speed_control(asked, motor);
  motion::PositionControl control;
  control.reference = asked.reference, control.sample_time = asked.sample_time;
  control.delay = common.delay, control.range = common.range, control.slew = common.slew;
  if (common.encoder) control.encoder = *common.encoder;
  control.gain = asked.gain, control.window = static_cast<double>(asked.window);
  control.off_time = asked.off_time, control.braking = asked.braking;
  return control;
}

motion::MotionTask motion_task(const MotionStudy& asked, const MotorDesign& motor) {
  motion::MotionTask task = motion::steady_drive(motor, asked.duration);
  task.initial = asked.initial;
  if (asked.drive.voltage) task.voltage = *asked.drive.voltage;
  if (asked.drive.amplitude) task.amplitude = *asked.drive.amplitude;
  if (asked.drive.frequency) task.frequency = *asked.drive.frequency;
  if (asked.load.torque) task.load_torque = *asked.load.torque;
  task.switched_off = asked.drive.switched_off;
  task.reversed = asked.drive.reversed;
  if (asked.drive.phase_difference) task.phase_difference = *asked.drive.phase_difference;
  task.engine = asked.engine, task.axial = asked.axial;
  task.accuracy = asked.accuracy.value_or(1);
  return task;
}

}  // namespace twum::inline v0_1::studies
