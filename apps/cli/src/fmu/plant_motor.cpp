// SPDX-License-Identifier: Apache-2.0
#include "fmu/plant_motor.hpp"

#include "motion/plant/plant_data.hpp"

#include <twum/motion/integrator_version.hpp>
#include <twum/motion/motion.hpp>

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::cli {
namespace {

using motion::PlantTable;

std::vector<float> in_floats(const std::vector<double>& values) {
  return {values.begin(), values.end()};
}

// A float is right to 1e-7, and a table to 1e-3.
PlantMotor::Side side_of(const motion::ContactTable& table) {
  return {in_floats(table.torque), in_floats(table.reactive_stiffness),
          in_floats(table.active_stiffness)};
}

PlantContact pointers(const PlantMotor::Side& side) {
  return {side[0].data(), side[1].data(), side[2].data()};
}

constexpr double kHalf = 0.02;         // start and stop [s]
constexpr std::size_t kSamples = 400;  // of both

constexpr double kTurns = 1e-6;  // [rad/s]: far above the speed with which a rotor leaves rest

// Times of the samples, the drive off from the middle on.
motion::MotionTask start_and_stop(const MotorDesign& design) {
  motion::MotionTask task = motion::steady_drive(design, 2 * kHalf);
  task.switched_off = {{kHalf, 2 * kHalf}};
  for (std::size_t i = 0; i <= kSamples; ++i)
    task.output_times.push_back(2 * kHalf * static_cast<double>(i) / kSamples);
  return task;
}

}  // namespace

PlantMotor::PlantMotor(const MotorDesign& design, const PlantTable& table)
    : along_(side_of(table.along)),
      against_(side_of(table.against)),
      data_(motion::plant_data(design, table)),
      first_inputs_(motion::plant_inputs(table)),
      parameters_(motion::plant_parameters(table)) {
  data_.along = pointers(along_), data_.against = pointers(against_);
}

PlantCheck check_plant(const MotorDesign& design, const PlantMotor& motor) {
  if (!motion::has_integrator()) return {"this build has no integrator of motions"};
  const motion::Motion exact = motion::simulate(design, start_and_stop(design));
  if (exact.status != "ok")
    return {"the motion with the exact contact ends early: " + exact.status};
  PlantState state = plant_at_rest();
  PlantInputs inputs = motor.first_inputs();
  double largest = 0, difference = 0, angle_at_off = 0;
  for (std::size_t i = 1; i <= kSamples; ++i) {
    inputs.enabled = i <= kSamples / 2 ? 1 : 0;
    if (const char* wrong = plant_advance(&motor.data(), &state, &inputs, &motor.parameters(),
                                          2 * kHalf / kSamples))
      return {wrong};
    const double speed = exact.samples[i].speed;
    largest = std::max(largest, std::abs(speed));
    difference = std::max(difference, std::abs(state.speed - speed));
    if (i == kSamples / 2) angle_at_off = state.angle;
  }
  const double stop = exact.last.angle - exact.samples[kSamples / 2].angle;
  if (largest < kTurns || stop == 0) return {"from rest the motor does not turn"};
  return {"", difference / largest, std::abs(state.angle - angle_at_off - stop) / std::abs(stop)};
}

}  // namespace twum::inline v0_1::cli
