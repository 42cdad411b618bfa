// SPDX-License-Identifier: Apache-2.0
#include "plant_outputs.hpp"

#include <cmath>
#include <utility>

namespace twum::inline v0_1::motion {
namespace {

constexpr double kRms = std::numbers::sqrt2 / 2;

}  // namespace

// The phasor of an output, with its derivatives in A, phi, V and f.
struct PlantOutputs::Phasor {
  Complex value, in_amplitude, in_phase, in_voltage, in_frequency;

  // I = i omega [C_0 (1 - i tan delta) u + Theta zeta] (D4.1)
  static Phasor of_current(const MotionModel& m, const PlantPoint& at) {
    const Complex admittance = m.capacitive_admittance(at.omega());
    const Complex motional = kI * at.omega() * m.force_factor * at.zeta();
    const Complex value = admittance * std::numbers::sqrt2 * at.voltage + motional;
    return {value, motional / at.amplitude, -kI * motional, admittance * std::numbers::sqrt2,
            value / at.frequency};
  }

  // U_e = -i omega Theta_e zeta e^(-i theta_e) / (i omega (C_e + C_load) + 1 / R_load) (D7.1)
  static Phasor of_sensor(const Sensor& sensor, const PlantPoint& at) {
    const double capacitance = sensor.capacitance + sensor.load_capacitance;
    const double conductance = sensor.load_resistance ? 1 / *sensor.load_resistance : 0;
    const Complex load = kI * at.omega() * capacitance + conductance;
    const Complex value = -kI * at.omega() * sensor.force_factor * at.zeta() *
                          std::polar(1.0, -sensor.position) / load;
    return {value, value / at.amplitude, -kI * value, 0,
            value / at.frequency * (1.0 - kI * at.omega() * capacitance / load)};
  }
};

PlantOutputs::PlantOutputs(const std::vector<Signal>& states) : count_(as_index(states.size())) {
  for (std::size_t i = 0; i < states.size(); ++i) {
    Row own = Row::Zero(count_);
    own[as_index(i)] = 1;
    add(states[i], own, Row::Zero(kPlantInputs));
  }
}

// With a coil the current is a state. Of a resistance alone it is (sqrt(2) V - u) / R_s.
void PlantOutputs::add_current(const MotionModel& model, const PlantPoint& at,
                               const StatePlaces& places) {
  if (places.voltage == StatePlaces::kNone)
    return add_size({"phase_current", "A"}, Phasor::of_current(model, at));
  const Complex I = at.terminals.current;
  const bool coil = places.current != StatePlaces::kNone;
  const double per_current = kRms / std::abs(I);
  const double per_state = coil ? per_current : -per_current / model.series_resistance;
  const Eigen::Index place = as_index(coil ? places.current : places.voltage);
  Row in_states = Row::Zero(count_), in_inputs = Row::Zero(kPlantInputs);
  in_states[place] = per_state * I.real(), in_states[place + 1] = per_state * I.imag();
  if (!coil) in_inputs[kV] = -std::numbers::sqrt2 * per_state * I.real();
  add({"phase_current", "A", kRms * std::abs(I)}, in_states, in_inputs);
}

void PlantOutputs::add_sensor(const Sensor& sensor, const PlantPoint& at) {
  const Phasor signal = Phasor::of_sensor(sensor, at);
  add_size({"sensor_voltage", "V"}, signal);
  add_lag({"sensor_phase", "rad"}, signal);
}

void PlantOutputs::add_size(Signal signal, const Phasor& p) {
  const double size = std::abs(p.value);
  signal.steady = kRms * size;
  add_real(std::move(signal), p,
           [&](Complex by) { return kRms * (std::conj(p.value) * by).real() / size; });
}

void PlantOutputs::add_lag(Signal signal, const Phasor& p) {
  signal.steady = -std::arg(p.value);
  add_real(std::move(signal), p, [&](Complex by) { return -(by / p.value).imag(); });
}

// A real number of a phasor, whose derivatives are linear in those of the phasor.
template <typename Part>
void PlantOutputs::add_real(Signal signal, const Phasor& p, Part part) {
  Row in_states = Row::Zero(count_), in_inputs = Row::Zero(kPlantInputs);
  in_states[kA] = part(p.in_amplitude), in_states[kPhi] = part(p.in_phase);
  in_inputs[kV] = part(p.in_voltage), in_inputs[kF] = part(p.in_frequency);
  add(std::move(signal), in_states, in_inputs);
}

void PlantOutputs::add(Signal signal, const Row& in_states, const Row& in_inputs) {
  signals.push_back(std::move(signal));
  c.push_back(in_states), d.push_back(in_inputs);
}

}  // namespace twum::inline v0_1::motion
