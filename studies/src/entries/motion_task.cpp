// SPDX-License-Identifier: Apache-2.0
#include "entries/motion_task.hpp"

#include <twum/core/parameters.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace twum::studies {

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
  task.engine = asked.engine;
  task.accuracy = asked.accuracy.value_or(1);
  return task;
}

}  // namespace twum::studies
