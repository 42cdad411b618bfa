// SPDX-License-Identifier: Apache-2.0
#include "fmu/plant_motor.hpp"

#include <twum/motion/integrator_version.hpp>
#include <twum/motion/motion.hpp>

#include <algorithm>
#include <cmath>

namespace twum::cli {
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

PlantMotor::PlantMotor(const MotorDesign& design, const PlantTable& t)
    : along_(side_of(t.along)), against_(side_of(t.against)) {
  const bool has_contact = t.opening_amplitude > 0;
  data_ = {.modal_mass = t.modal_mass,
           .modal_damping = t.modal_damping,
           .modal_stiffness = t.modal_stiffness,
           .force_factor = t.force_factor,
           .blocked_capacitance = t.blocked_capacitance,
           .loss_tangent = t.loss_tangent,
           .frequency = t.frequency,
           .opening_amplitude = has_contact ? t.opening_amplitude : t.amplitudes.back(),
           .holding_torque = t.holding_torque,
           .crest_per_amplitude = t.crest_per_amplitude,
           .has_sensor = design.stator.sensor ? 1 : 0,
           .sensor_force_factor = 0,
           .sensor_capacitance = 0,
           .sensor_conductance = 0,
           .amplitudes = static_cast<int>(t.amplitudes.size()),
           .speed_ratios = static_cast<int>(t.speed_ratios.size()),
           .largest_amplitude = t.amplitudes.back(),
           .along = pointers(along_),
           .against = pointers(against_)};
  if (const auto& sensor = design.stator.sensor) {
    data_.sensor_force_factor = sensor->force_factor;
    data_.sensor_capacitance = sensor->capacitance + sensor->load_capacitance;
    data_.sensor_conductance = sensor->load_resistance ? 1 / *sensor->load_resistance : 0;
  }
  first_inputs_ = {t.voltage, t.frequency, 0, 1, 1};
  parameters_ = {t.rotor_inertia, t.load_inertia, t.load_damping, t.load_friction,
                 t.off_resistance};
}

PlantCheck check_plant(const MotorDesign& design, const PlantMotor& motor) {
  if (!motion::has_integrator()) return {"this build has no integrator of motions"};
  if (design.stator.radial_motion) return {"motions in time leave out the radial motion"};
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

}  // namespace twum::cli
