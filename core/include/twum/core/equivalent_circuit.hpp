// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motor.hpp>
#include <twum/core/parameters.hpp>

#include <array>
#include <complex>
#include <optional>

namespace twum::inline v0_1 {

/// Circuit of a phase of the free stator: C_0 in parallel with R_m, L_m and C_m in series (D4.4). An impedance analyser gives
/// the first four values, with the other phase shorted. Theta fixes the scale of the mechanical data.
struct EquivalentCircuit {
  double motional_resistance;   ///< R_m [ohm]
  double motional_inductance;   ///< L_m [H]
  double motional_capacitance;  ///< C_m [F]
  double blocked_capacitance;   ///< C_0 [F]
  double force_factor;          ///< Theta [N/V]
};

/// Impedance that the contact adds in series with R_m, L_m and C_m at an operating point (D4.5).
struct ContactCircuit {
  double
      resistance;  ///< P_in / (omega A Theta)^2 [ohm], negative where the rotor drives the stator
  double capacitance;  ///< Theta^2 A / Re F [F], infinite where the contact has no reactive force
};

/// The equivalent circuit of a design's modal data (D4.4); nothing without modal data (has_modal_data()).
std::optional<EquivalentCircuit> equivalent_circuit(const MotorDesign& design);

/// The modal data of an equivalent circuit (D4.4): resonance_frequency, modal_mass, quality_factor, force_factor and
/// blocked_capacitance. The inverse of equivalent_circuit() up to rounding. Never throws; the caller ensures positive
/// values.
std::array<ParameterValue, 5> modal_data(const EquivalentCircuit& circuit);

/// The contact as a part of the circuit at an operating point of a motor with modal data; NaN where the point has no answer.
ContactCircuit contact_circuit(const Motor& motor, const OperatingPoint& point);

/// The circuit of a phase under load: the contact's resistance and capacitance in series with R_m, L_m and C_m.
EquivalentCircuit with_contact(const EquivalentCircuit& circuit, const ContactCircuit& contact);

/// Resonance of the series branch, 1 / (2 pi sqrt(L_m C_m)) [Hz]: of the free stator its resonance_frequency, under load the
/// loaded resonance (D3.1).
double series_resonance(const EquivalentCircuit& circuit);

/// Resonance of the series branch with C_0, f_s sqrt(1 + C_m / C_0) [Hz]; infinite without C_0.
double parallel_resonance(const EquivalentCircuit& circuit);

/// C_m / C_0, infinite without C_0, and sqrt(C_m / (C_0 + C_m)), the effective coupling factor [1].
/// @{
double capacitance_ratio(const EquivalentCircuit& circuit);
double coupling_factor(const EquivalentCircuit& circuit);
/// @}

/// Admittance of a phase at a frequency [Hz]: i omega C_0 (1 - i tan delta), as in (D4.1), and the series branch [S].
std::complex<double> admittance(const EquivalentCircuit& circuit, double loss_tangent,
                                double frequency);

}  // namespace twum::inline v0_1
