// SPDX-License-Identifier: Apache-2.0
#include "metrics/circuit_quantity.hpp"

#include <twum/core/equivalent_circuit.hpp>
#include <twum/core/parameters.hpp>

#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

namespace twum::inline v0_1::motors {
namespace {

using Complex = std::complex<double>;

constexpr std::array<CircuitPartInfo, kCircuitParts> kParts{{{"conductance", "S"},
                                                             {"susceptance", "S"},
                                                             {"impedance", "ohm"},
                                                             {"impedance_phase", "rad"},
                                                             {"resistance", "ohm"},
                                                             {"reactance", "ohm"}}};

struct Slope {
  Parameter parameter;
  Complex admittance;
};

// Y = i omega C_0 (1 - i tan delta) + Theta^2 / Z by its arguments, Z = d_s + i (omega m - k / omega),
// k = m (2 pi f_r)^2.
std::array<Slope, 7> slopes(const MotorDesign& design, const EquivalentCircuit& circuit,
                            double frequency) {
  constexpr double kTurn = 2 * std::numbers::pi;
  const double omega = kTurn * frequency;
  const double theta = circuit.force_factor;
  const double damping = circuit.motional_resistance * theta * theta;
  const double mass = circuit.motional_inductance * theta * theta;
  const double stiffness = theta * theta / circuit.motional_capacitance;
  const double tangent = get(design, Parameter::loss_tangent);
  const Complex i(0, 1);
  const Complex z = damping + i * (omega * mass - stiffness / omega);
  const Complex by_z = -theta * theta / (z * z);
  const double resonance = std::sqrt(stiffness / mass) / kTurn;
  const Complex leak = i * circuit.blocked_capacitance * (1.0 - i * tangent);
  return {{{Parameter::frequency, kTurn * (leak + by_z * i * (mass + stiffness / (omega * omega)))},
           {Parameter::resonance_frequency, by_z * -i * (2 * stiffness / resonance / omega)},
           {Parameter::modal_mass, by_z * i * (omega - stiffness / mass / omega)},
           {Parameter::modal_damping, by_z},
           {Parameter::force_factor, 2 * theta / z},
           {Parameter::blocked_capacitance, i * omega * (1.0 - i * tangent)},
           {Parameter::loss_tangent, Complex(omega * circuit.blocked_capacitance)}}};
}

double part_of(Complex y, CircuitPart part) {
  switch (part) {
    case CircuitPart::conductance: return y.real();
    case CircuitPart::susceptance: return y.imag();
    case CircuitPart::impedance: return 1 / std::abs(y);
    case CircuitPart::impedance_phase: return -std::arg(y);
    case CircuitPart::resistance: return (1.0 / y).real();
    case CircuitPart::reactance: return (1.0 / y).imag();
  }
  return std::numeric_limits<double>::quiet_NaN();
}

// Derivative of the quantity for a change of the admittance.
double change_of(Complex y, Complex slope, CircuitPart part) {
  switch (part) {
    case CircuitPart::conductance: return slope.real();
    case CircuitPart::susceptance: return slope.imag();
    case CircuitPart::impedance: return -(slope / y).real() / std::abs(y);
    case CircuitPart::impedance_phase: return -(slope / y).imag();
    case CircuitPart::resistance: return -(slope / (y * y)).real();  // d(1/Y) = -dY / Y^2
    case CircuitPart::reactance: return -(slope / (y * y)).imag();
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

const CircuitPartInfo& info(CircuitPart part) { return kParts[static_cast<std::size_t>(part)]; }

bool same_number(CircuitPart a, CircuitPart b) {
  const auto pair = [&](CircuitPart real, CircuitPart imaginary) {
    return (a == real || a == imaginary) && (b == real || b == imaginary);
  };
  return a == b || pair(CircuitPart::conductance, CircuitPart::susceptance) ||
         pair(CircuitPart::resistance, CircuitPart::reactance);
}

std::optional<CircuitPart> find_circuit_part(std::string_view name) {
  for (std::size_t k = 0; k < kParts.size(); ++k)
    if (kParts[k].name == name) return static_cast<CircuitPart>(k);
  return {};
}

MetricDerivative differentiate(const MotorDesign& design, CircuitPart part,
                               bool fixed_static_friction) {
  MetricDerivative result;
  const auto circuit = equivalent_circuit(design);
  if (!circuit) {
    result.value = {std::numeric_limits<double>::quiet_NaN(), MetricStatus::undefined};
    return result;
  }
  const double frequency = get(design, Parameter::frequency);
  const Complex y = admittance(*circuit, get(design, Parameter::loss_tangent), frequency);
  result.value = {part_of(y, part), MetricStatus::ok};
  const ParameterJacobian follows = parameter_jacobian(design, fixed_static_friction);
  for (const Slope& slope : slopes(design, *circuit, frequency)) {
    const double change = change_of(y, slope.admittance, part);
    const auto& row = follows[index_of(slope.parameter)];
    for (std::size_t j = 0; j < row.size(); ++j)
      if (row[j] != 0) result.gradient[j] += change * row[j];
  }
  return result;
}

}  // namespace twum::inline v0_1::motors
