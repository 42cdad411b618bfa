// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/phasor.hpp"

#include <twum/base/dual.hpp>
#include <twum/core/motor_design.hpp>
#include <twum/core/parameters.hpp>

#include <cmath>
#include <numbers>
#include <optional>

namespace twum::core {

/// Differences between the phases and between the modes (D6.1, D6.5).
template <typename S>
struct UnequalPhases {
  S voltage_ratio = S(1.0), phase_error = S(0.0), mode_splitting = S(0.0);

  bool none() const {
    return value_of(voltage_ratio) == 1 && value_of(phase_error) == 0 &&
           value_of(mode_splitting) == 0;
  }
  /// (1 + rho e^(i eps)) / 2: share of the voltage that drives the forward wave (D6.1).
  Phasor<S> forward() const {
    using std::sin, std::cos;
    return {0.5 * (1.0 + voltage_ratio * cos(phase_error)),
            0.5 * (voltage_ratio * sin(phase_error))};
  }
  /// (1 - rho e^(-i eps)) / 2: share that drives the backward wave (D6.5).
  Phasor<S> backward() const {
    using std::sin, std::cos;
    return {0.5 * (1.0 - voltage_ratio * cos(phase_error)),
            0.5 * (voltage_ratio * sin(phase_error))};
  }
  /// u_f / u_0
  S share() const {
    using std::sqrt;
    return sqrt(forward().squared());
  }
};

/// A sensor electrode and its load (D7.1).
template <typename S>
struct SensorCircuit {
  S force_factor, capacitance, load_capacitance;
  std::optional<S> load_resistance;
  S position;
};

/// The two modes of the stator that make up the wave, with their phases (D2.1).
template <typename S>
struct StatorModes {
  S mass;          ///< m_s of each mode, for the displacement at the contact radius [kg]
  S resonance;     ///< 2 pi f_r of the free stator [rad/s]
  S damping;       ///< d_s [N s/m]
  S force_factor;  ///< Theta of a phase [N/V]
  S capacitance;   ///< C_0 of a phase [F]
  S loss_tangent;  ///< tan delta of C_0 [1]
  UnequalPhases<S> unequal{};
  std::optional<S> rotor_mass{};  ///< [kg]
  std::optional<SensorCircuit<S>> sensor{};

  /// Voltage of the first phase, rms, whose drive has a force [V].
  S rms_voltage(const S& force) const {
    return force / (std::numbers::sqrt2 * force_factor * unequal.share());
  }
};

/// The modes of a design; nothing without modal data.
inline std::optional<StatorModes<double>> stator_modes(const MotorDesign& design) {
  if (!has_modal_data(design)) return {};
  const auto value = [&](Parameter parameter) { return get(design, parameter); };
  const Stator& s = design.stator;
  StatorModes<double> modes{value(Parameter::modal_mass),
                            2 * std::numbers::pi * value(Parameter::resonance_frequency),
                            modal_damping(design),
                            value(Parameter::force_factor),
                            value(Parameter::blocked_capacitance),
                            value(Parameter::loss_tangent)};
  if (s.imbalance)
    modes.unequal = {s.imbalance->voltage_ratio, s.imbalance->phase_error,
                     s.imbalance->mode_splitting};
  if (design.rotor.mass) modes.rotor_mass = *design.rotor.mass;
  if (s.sensor)
    modes.sensor = SensorCircuit<double>{s.sensor->force_factor, s.sensor->capacitance,
                                         s.sensor->load_capacitance, s.sensor->load_resistance,
                                         s.sensor->position};
  return modes;
}

/// The modes, with `to` applied to the value of each parameter.
template <typename S, typename To>
StatorModes<S> converted(const StatorModes<double>& m, To to) {
  using P = Parameter;
  constexpr double kTurn = 2 * std::numbers::pi;
  StatorModes<S> modes{to(P::modal_mass, m.mass),
                       kTurn * to(P::resonance_frequency, m.resonance / kTurn),
                       to(P::modal_damping, m.damping),
                       to(P::force_factor, m.force_factor),
                       to(P::blocked_capacitance, m.capacitance),
                       to(P::loss_tangent, m.loss_tangent)};
  modes.unequal = {to(P::voltage_ratio, m.unequal.voltage_ratio),
                   to(P::phase_error, m.unequal.phase_error),
                   to(P::mode_splitting, m.unequal.mode_splitting)};
  if (m.rotor_mass) modes.rotor_mass = to(P::rotor_mass, *m.rotor_mass);
  if (!m.sensor) return modes;
  modes.sensor = SensorCircuit<S>{to(P::sensor_force_factor, m.sensor->force_factor),
                                  to(P::sensor_capacitance, m.sensor->capacitance),
                                  to(P::sensor_load_capacitance, m.sensor->load_capacitance),
                                  {},
                                  to(P::sensor_position, m.sensor->position)};
  if (m.sensor->load_resistance)
    modes.sensor->load_resistance = to(P::sensor_load_resistance, *m.sensor->load_resistance);
  return modes;
}

/// The modes as constants.
template <typename S>
StatorModes<S> constant_modes(const StatorModes<double>& m) {
  auto modes = converted<S>(m, [](Parameter, double x) { return S(x); });
  modes.resonance = S(m.resonance);
  return modes;
}

/// k_s - omega^2 m_s, without the cancellation of its two terms [N/m].
template <typename S>
S dynamic_stiffness(const StatorModes<S>& m, const S& omega) {
  return m.mass * (m.resonance - omega) * (m.resonance + omega);
}

/// R + i I, the force that a wave needs from the drive, in the frame of the wave (D2.3) [N].
template <typename S>
struct WaveBalance {
  S real, imaginary;

  /// H, the size of the force.
  S force() const {
    using std::sqrt;
    return sqrt(real * real + imaginary * imaginary);
  }
};

/// R and I of a wave with an amplitude, on which the contact acts with Re F and from which it takes P_in (D1.2,
/// D2.3).
template <typename S>
WaveBalance<S> wave_balance(const StatorModes<S>& m, const S& amplitude, const S& omega,
                            const S& reactive_force, const S& stator_power) {
  const S velocity = omega * amplitude;
  return {dynamic_stiffness(m, omega) * amplitude + reactive_force,
          m.damping * velocity + stator_power / velocity};
}

/// Quantities at the terminals. Powers are those of both phases together, voltage and current those of one.
template <typename S>
struct Terminals {
  S voltage;          ///< that holds the wave, rms [V]
  S current;          ///< rms [A] (D4.1)
  S dielectric_loss;  ///< in C_0 [W]
  S power;            ///< P_el [W] (D4.2)
  S power_factor;     ///< (D4.3) [1]
};

/// Currents of the two phases, peak (D4.1, D6.6) [A].
template <typename S>
struct PhaseCurrents {
  S first, second;
};
template <typename S>
PhaseCurrents<S> phase_currents(const StatorModes<S>& m, const WaveBalance<S>& w,
                                const S& amplitude, const S& omega, const S& voltage,
                                const Phasor<S>& backward) {
  using std::sqrt, std::sin, std::cos;
  const S force = w.force(), motional = omega * m.force_factor;
  const Phasor<S> lead = (1.0 / m.unequal.share()) * m.unequal.forward();
  const Phasor<S> wave = (amplitude / force) * (Phasor<S>{w.real, -w.imaginary} * lead);
  const Phasor<S> blocked = S(omega * m.capacitance * voltage) * Phasor<S>{S(1.0), -m.loss_tangent};
  const S& rho = m.unequal.voltage_ratio;
  const Phasor<S> second{rho * cos(m.unequal.phase_error), rho * sin(m.unequal.phase_error)};
  const Phasor<S> one = blocked + motional * (wave + backward.conjugate());
  const Phasor<S> two = blocked * second + motional * (wave - backward.conjugate());
  return {sqrt(one.squared()), sqrt(two.squared())};
}

/// Part of the first phase's current that leads its voltage by a quarter of a turn, peak (D4.1, D6.6) [A].
template <typename S>
S reactive_current(const StatorModes<S>& m, const WaveBalance<S>& w, const S& amplitude,
                   const S& omega, const S& voltage, const Phasor<S>& backward) {
  const Phasor<S> lead = (1.0 / m.unequal.share()) * m.unequal.forward();
  const Phasor<S> wave = (amplitude / w.force()) * (Phasor<S>{w.real, -w.imaginary} * lead);
  return omega * (m.capacitance * voltage + m.force_factor * (wave + backward.conjugate()).real);
}

/// @param backward  z of (D6.5); powers do not depend on it to first order [m]
template <typename S>
Terminals<S> terminals(const StatorModes<S>& m, const WaveBalance<S>& w, const S& amplitude,
                       const S& omega, const Phasor<S>& backward = {S(0.0), S(0.0)}) {
  using std::sqrt;
  const S velocity = omega * amplitude, force = w.force();
  const S voltage = force / m.force_factor / m.unequal.share();
  const S susceptance = omega * m.capacitance, rms(std::sqrt(0.5));
  const S dielectric = susceptance * m.loss_tangent * voltage * voltage;
  if (m.unequal.none()) {
    const S motional = m.force_factor * velocity / force;  // current per R + i I
    const S active = susceptance * m.loss_tangent * voltage + motional * w.imaginary;
    const S reactive = susceptance * voltage + motional * w.real;
    const S current = sqrt(active * active + reactive * reactive);
    return {rms * voltage, rms * current, dielectric, dielectric + velocity * w.imaginary,
            active / current};
  }
  const S& rho = m.unequal.voltage_ratio;
  const S loss = 0.5 * (1.0 + rho * rho) * dielectric, power = loss + velocity * w.imaginary;
  const PhaseCurrents<S> i = phase_currents(m, w, amplitude, omega, voltage, backward);
  const S larger = value_of(i.first) < value_of(i.second) ? i.second : i.first;
  return {rms * voltage, rms * larger, loss, power,
          2.0 * power / (voltage * (i.first + rho * i.second))};
}

/// Voltage of the sensor, rms [V], and its lag behind the voltage of the first phase [rad] (D7.1).
template <typename S>
struct SensorSignal {
  S voltage, phase;
};
template <typename S>
SensorSignal<S> sensor_signal(const StatorModes<S>& m, const WaveBalance<S>& w, const S& amplitude,
                              const S& omega) {
  using std::sqrt, std::sin, std::cos;
  const SensorCircuit<S>& e = *m.sensor;
  const S conductance = e.load_resistance ? S(1.0 / *e.load_resistance) : S(0.0);
  const Phasor<S> admittance{conductance, omega * (e.capacitance + e.load_capacitance)};
  const Phasor<S> place{cos(e.position), sin(e.position)};
  // The inverse of the phasor: its angle is the lag.
  const Phasor<S> inverse =
      Phasor<S>{-w.imaginary, w.real} * m.unequal.forward().conjugate() * place * admittance;
  const S sign(value_of(e.force_factor) < 0 ? -1.0 : 1.0);
  return {std::sqrt(0.5) * (sign * e.force_factor * omega * amplitude) / sqrt(admittance.squared()),
          argument(S(sign * inverse.real), S(sign * inverse.imaginary))};
}

}  // namespace twum::core
