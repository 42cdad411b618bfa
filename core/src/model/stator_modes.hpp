// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/scalars.hpp"
#include "model/phasor.hpp"

#include <twum/base/dual.hpp>
#include <twum/core/motor_design.hpp>
#include <twum/core/parameters.hpp>

#include <cmath>
#include <numbers>
#include <optional>
#include <type_traits>

namespace twum::inline v0_1::core {

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

/// What stands between the inverter and each phase.
template <typename S>
struct SeriesBranch {
  S inductance;  ///< L_s [H]
  S resistance;  ///< R_s [ohm]
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
  std::optional<SeriesBranch<S>> series{};

  /// True if the driver is not ideal. Its derivatives are those of a branch even where this has no impedance.
  bool has_series() const {
    if constexpr (!contact::kHasSeriesBranch) return false;
    if constexpr (!std::is_same_v<S, double>) return series.has_value();
    return series && (value_of(series->inductance) != 0 || value_of(series->resistance) != 0);
  }
  /// Voltage of the inverter at the first phase, rms, whose drive has a force [V].
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
  if (contact::kHasSeriesBranch && design.driver)
    modes.series = SeriesBranch<double>{design.driver->inductance, design.driver->resistance};
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
  if constexpr (contact::kHasSeriesBranch)
    if (m.series)
      modes.series = SeriesBranch<S>{to(P::driver_inductance, m.series->inductance),
                                     to(P::driver_resistance, m.series->resistance)};
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

/// The inverter's voltage and a series branch act on the wave by alpha and beta of (D8.2):
/// alpha = 1 / (1 + Z_s Y), beta = i omega Theta^2 Z_s alpha, with Z_s = R_s + i omega L_s, Y = i omega C_0 (1 - i tan delta).
template <typename S>
struct SeriesAction {
  Phasor<S> impedance;  ///< Z_s [ohm]
  Phasor<S> blocked;    ///< 1 / alpha = 1 + Z_s Y [1]
  Phasor<S> feedback;   ///< beta / alpha = i omega Theta^2 Z_s [N/m]
  S size;               ///< 1 / |alpha| [1]

  /// beta [N/m]
  Phasor<S> stiffness() const { return feedback / blocked; }
};
template <typename S>
SeriesAction<S> series_action(const StatorModes<S>& m, const S& omega) {
  using std::sqrt;
  const Phasor<S> impedance{m.series->resistance, omega * m.series->inductance};
  const S susceptance = omega * m.capacitance;
  const Phasor<S> change = impedance * Phasor<S>{susceptance * m.loss_tangent, susceptance};
  const Phasor<S> blocked{1.0 + change.real, change.imaginary};
  const S rate = omega * m.force_factor * m.force_factor;
  return {impedance,
          blocked,
          {-(rate * impedance.imaginary), rate * impedance.real},
          S(sqrt(blocked.squared()))};
}

/// d Re beta / d omega^2 [kg]: with it a small change of the frequency finds the modal mass m_s less this.
template <typename S>
S series_mass(const StatorModes<S>& m, const S& omega) {
  const SeriesAction<S> a = series_action(m, omega);
  const Phasor<S> beta = a.stiffness();
  const S theta = m.force_factor * m.force_factor, &L = m.series->inductance;
  // beta = N / D: beta' = (N' - beta D') / D, Y = omega Y'
  const Phasor<S> admittance{m.capacitance * m.loss_tangent, m.capacitance};  // Y'
  const Phasor<S> top{-(2.0 * theta * omega * L), theta * m.series->resistance};
  const Phasor<S> bottom =
      (Phasor<S>{m.series->resistance, 2.0 * omega * L}) * admittance;  // (Z_s Y)'
  return ((top - beta * bottom) / a.blocked).real / (2.0 * omega);
}

/// R + i I of (D8.3): the force that a wave needs from the inverter's voltage, whose size H is Theta times it. The frame is that of
/// alpha times the voltage, so that the wave lags behind the voltage by its angle and that of 1 / alpha. Without a series branch
/// that of (D2.3).
/// @param own  of the stator (D2.3)
template <typename S>
WaveBalance<S> drive_balance(const StatorModes<S>& m, const WaveBalance<S>& own, const S& amplitude,
                             const S& omega) {
  if (!m.has_series()) return own;
  const SeriesAction<S> a = series_action(m, omega);
  const Phasor<S> feedback = (amplitude / a.size) * (a.feedback * a.blocked.conjugate());
  return {a.size * own.real + feedback.real, a.size * own.imaginary + feedback.imaginary};
}

/// Angle by which alpha times the inverter's voltage lags behind it (D8.2) [rad].
template <typename S>
S divider_lag(const StatorModes<S>& m, const S& omega) {
  if (!m.has_series()) return S(0.0);
  const Phasor<S> blocked = series_action(m, omega).blocked;
  return argument(blocked.real, blocked.imaginary);
}

/// phi, lag of the wave behind the inverter's voltage (D2.4) [rad]: the sum of both angles, each of which stays within half a turn.
/// @param drive  drive_balance()
template <typename S>
S phase_lag(const StatorModes<S>& m, const WaveBalance<S>& drive, const S& omega) {
  return argument(drive.real, drive.imaginary) + divider_lag(m, omega);
}

/// The same in the frame of the inverter's voltage: phi is its angle (D2.4).
template <typename S>
WaveBalance<S> inverter_balance(const StatorModes<S>& m, const WaveBalance<S>& own,
                                const S& amplitude, const S& omega) {
  if (!m.has_series()) return own;
  const SeriesAction<S> a = series_action(m, omega);
  const Phasor<S> force = a.blocked * Phasor<S>{own.real, own.imaginary} + amplitude * a.feedback;
  return {force.real, force.imaginary};
}

/// Quantities at the inverter. Powers are those of both phases together, voltage and current those of one.
template <typename S>
struct Terminals {
  S voltage;           ///< that holds the wave, rms [V]
  S current;           ///< rms [A] (D4.1)
  S dielectric_loss;   ///< in C_0 [W]
  S power;             ///< P_el [W] (D4.2)
  S power_factor;      ///< (D4.3) [1]
  S driver_loss;       ///< in R_s (D8.5) [W]
  S terminal_voltage;  ///< across a phase, behind the series branch, rms [V]
};

/// Currents of the two phases, peak, and the voltages across them (D4.1, D6.6, D8.4) [A, V].
template <typename S>
struct PhaseCurrents {
  S first, second;
  S first_voltage, second_voltage;
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
  if (!m.has_series()) return {sqrt(one.squared()), sqrt(two.squared()), voltage, rho * voltage};
  // one and two are (1 + Z_s Y) I over i and 1: u = V - Z_s I
  const SeriesAction<S> a = series_action(m, omega);
  const Phasor<S> drop = a.impedance / a.blocked * Phasor<S>{S(0.0), S(1.0)};
  const Phasor<S> u = Phasor<S>{voltage, S(0.0)} - drop * one, v = voltage * second - drop * two;
  return {sqrt(one.squared()) / a.size, sqrt(two.squared()) / a.size, sqrt(u.squared()),
          sqrt(v.squared())};
}

/// Part of the first phase's current that leads the inverter's voltage by a quarter of a turn, peak (D4.1, D6.6, D8.4) [A].
/// @param w  inverter_balance()
template <typename S>
S reactive_current(const StatorModes<S>& m, const WaveBalance<S>& w, const S& amplitude,
                   const S& omega, const S& voltage, const Phasor<S>& backward) {
  const Phasor<S> lead = (1.0 / m.unequal.share()) * m.unequal.forward();
  const Phasor<S> wave = (amplitude / w.force()) * (Phasor<S>{w.real, -w.imaginary} * lead);
  const S ideal =
      omega * (m.capacitance * voltage + m.force_factor * (wave + backward.conjugate()).real);
  if (!m.has_series()) return ideal;
  const S active = omega * (m.capacitance * m.loss_tangent * voltage -
                            m.force_factor * (wave + backward.conjugate()).imaginary);
  return (Phasor<S>{ideal, -active} / series_action(m, omega).blocked).real;
}

/// Behind a series branch (D8.3 to D8.5). The wave's share of the voltage and the rest of it, which drives the backward wave, heat
/// C_0 and R_s each by itself.
template <typename S>
Terminals<S> terminals_behind_series(const StatorModes<S>& m, const WaveBalance<S>& own,
                                     const S& amplitude, const S& omega,
                                     const Phasor<S>& backward) {
  using std::sqrt;
  const SeriesAction<S> a = series_action(m, omega);
  const WaveBalance<S> w = inverter_balance(m, own, amplitude, omega);
  const S voltage = w.force() / m.force_factor / m.unequal.share(), rms(std::sqrt(0.5));
  const S susceptance = omega * m.capacitance;
  const Phasor<S> admittance{susceptance * m.loss_tangent, susceptance};
  const Phasor<S> across{own.real / m.force_factor, own.imaginary / m.force_factor};
  const Phasor<S> current =
      admittance * across + Phasor<S>{S(0.0), omega * m.force_factor * amplitude};
  const S rest = (voltage / a.size) * (voltage / a.size) * m.unequal.backward().squared();
  const S dielectric = susceptance * m.loss_tangent * (across.squared() + rest);
  const S driver = m.series->resistance * (current.squared() + admittance.squared() * rest);
  const S power = dielectric + driver + omega * amplitude * own.imaginary;
  if (m.unequal.none()) {
    const S size = sqrt(current.squared());
    return {rms * voltage,
            rms * size,
            dielectric,
            power,
            power / (voltage * size),
            driver,
            rms * sqrt(across.squared())};
  }
  const PhaseCurrents<S> i = phase_currents(m, w, amplitude, omega, voltage, backward);
  const S larger = value_of(i.first) < value_of(i.second) ? i.second : i.first;
  const S highest =
      value_of(i.first_voltage) < value_of(i.second_voltage) ? i.second_voltage : i.first_voltage;
  return {rms * voltage,
          rms * larger,
          dielectric,
          power,
          2.0 * power / (voltage * (i.first + m.unequal.voltage_ratio * i.second)),
          driver,
          rms * highest};
}

/// @param w         of the stator (D2.3)
/// @param backward  z of (D6.5); powers do not depend on it to first order [m]
template <typename S>
Terminals<S> terminals(const StatorModes<S>& m, const WaveBalance<S>& w, const S& amplitude,
                       const S& omega, const Phasor<S>& backward = {S(0.0), S(0.0)}) {
  using std::sqrt;
  if (m.has_series()) return terminals_behind_series(m, w, amplitude, omega, backward);
  const S velocity = omega * amplitude, force = w.force();
  const S voltage = force / m.force_factor / m.unequal.share();
  const S susceptance = omega * m.capacitance, rms(std::sqrt(0.5));
  const S dielectric = susceptance * m.loss_tangent * voltage * voltage;
  if (m.unequal.none()) {
    const S motional = m.force_factor * velocity / force;  // current per R + i I
    const S active = susceptance * m.loss_tangent * voltage + motional * w.imaginary;
    const S reactive = susceptance * voltage + motional * w.real;
    const S current = sqrt(active * active + reactive * reactive);
    return {rms * voltage,    rms * current, dielectric,   dielectric + velocity * w.imaginary,
            active / current, S(0.0),        rms * voltage};
  }
  const S& rho = m.unequal.voltage_ratio;
  const S loss = 0.5 * (1.0 + rho * rho) * dielectric, power = loss + velocity * w.imaginary;
  const PhaseCurrents<S> i = phase_currents(m, w, amplitude, omega, voltage, backward);
  const S larger = value_of(i.first) < value_of(i.second) ? i.second : i.first;
  return {rms * voltage,
          rms * larger,
          loss,
          power,
          2.0 * power / (voltage * (i.first + rho * i.second)),
          S(0.0),
          value_of(rho) > 1 ? S(rms * rho * voltage) : S(rms * voltage)};
}

/// Voltage of the sensor, rms [V], and its lag behind the voltage of the first phase [rad] (D7.1).
/// @param w  inverter_balance()
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

}  // namespace twum::inline v0_1::core
