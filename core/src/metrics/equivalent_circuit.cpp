// SPDX-License-Identifier: Apache-2.0
#include <twum/core/equivalent_circuit.hpp>

#include "model/stator_modes.hpp"

#include <twum/base/error.hpp>

#include <cmath>
#include <numbers>

namespace twum::inline v0_1 {
namespace {

constexpr double kFullTurn = 2 * std::numbers::pi;

}  // namespace

std::optional<EquivalentCircuit> equivalent_circuit(const MotorDesign& design) {
  const auto modes = core::stator_modes(design);
  if (!modes) return {};
  const double scale = modes->force_factor * modes->force_factor;
  const double stiffness = modes->mass * modes->resonance * modes->resonance;
  return EquivalentCircuit{modes->damping / scale, modes->mass / scale, scale / stiffness,
                           modes->capacitance, modes->force_factor};
}

std::array<ParameterValue, 5> modal_data(const EquivalentCircuit& c) {
  const double reactance = std::sqrt(c.motional_inductance / c.motional_capacitance);
  return {{{Parameter::resonance_frequency, series_resonance(c)},
           {Parameter::modal_mass, c.motional_inductance * c.force_factor * c.force_factor},
           {Parameter::quality_factor, reactance / c.motional_resistance},
           {Parameter::force_factor, c.force_factor},
           {Parameter::blocked_capacitance, c.blocked_capacitance}}};
}

ContactCircuit contact_circuit(const Motor& motor, const OperatingPoint& point) {
  const MotorDesign& design = motor.design();
  const double force_factor = get(design, Parameter::force_factor);
  const double current = kFullTurn * drive_frequency(design) * point.amplitude * force_factor;
  return {point.stator_power / (current * current),
          force_factor * force_factor * point.amplitude / point.reactive_force};
}

EquivalentCircuit with_contact(const EquivalentCircuit& circuit, const ContactCircuit& contact) {
  EquivalentCircuit loaded = circuit;
  loaded.motional_resistance += contact.resistance;
  loaded.motional_capacitance = 1 / (1 / circuit.motional_capacitance + 1 / contact.capacitance);
  return loaded;
}

double series_resonance(const EquivalentCircuit& c) {
  return 1 / (kFullTurn * std::sqrt(c.motional_inductance * c.motional_capacitance));
}

double parallel_resonance(const EquivalentCircuit& c) {
  return series_resonance(c) * std::sqrt(1 + capacitance_ratio(c));
}

double capacitance_ratio(const EquivalentCircuit& c) {
  return c.motional_capacitance / c.blocked_capacitance;
}

double coupling_factor(const EquivalentCircuit& c) {
  return std::sqrt(c.motional_capacitance / (c.blocked_capacitance + c.motional_capacitance));
}

std::complex<double> admittance(const EquivalentCircuit& c, double loss_tangent, double frequency) {
  const double omega = kFullTurn * frequency;
  const double reactance = omega * c.motional_inductance - 1 / (omega * c.motional_capacitance);
  return omega * c.blocked_capacitance * std::complex<double>(loss_tangent, 1) +
         1.0 / std::complex<double>(c.motional_resistance, reactance);
}

}  // namespace twum::inline v0_1
