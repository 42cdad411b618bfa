// SPDX-License-Identifier: Apache-2.0
#include "motion/plant/plant_data.hpp"

namespace twum::inline v0_1::motion {

PlantData plant_data(const MotorDesign& design, const PlantTable& t) {
  const bool has_contact = t.opening_amplitude > 0;
  PlantData data{};
  data.modal_mass = t.modal_mass, data.modal_damping = t.modal_damping;
  data.modal_stiffness = t.modal_stiffness, data.force_factor = t.force_factor;
  data.blocked_capacitance = t.blocked_capacitance, data.loss_tangent = t.loss_tangent;
  data.frequency = t.frequency;
  data.opening_amplitude = has_contact ? t.opening_amplitude : t.amplitudes.back();
  data.holding_torque = t.holding_torque;
  data.crest_per_amplitude = t.crest_per_amplitude;
  data.amplitudes = static_cast<int>(t.amplitudes.size());
  data.speed_ratios = static_cast<int>(t.speed_ratios.size());
  data.largest_amplitude = t.amplitudes.back();
  if (const auto& sensor = design.stator.sensor) {
    data.has_sensor = 1;
    data.sensor_force_factor = sensor->force_factor;
    data.sensor_capacitance = sensor->capacitance + sensor->load_capacitance;
    data.sensor_conductance = sensor->load_resistance ? 1 / *sensor->load_resistance : 0;
  }
  return data;
}

PlantInputs plant_inputs(const PlantTable& t) { return {t.voltage, t.frequency, 0, 1, 1}; }

PlantParameters plant_parameters(const PlantTable& t) {
  return {t.rotor_inertia, t.load_inertia, t.load_damping, t.load_friction, t.off_resistance};
}

}  // namespace twum::inline v0_1::motion
