// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/design/parameters.hpp>

#include <cmath>
#include <numbers>
#include <optional>

namespace twum::performance {

/// The two modes of the stator that make up the wave, with their phases (D2.1).
template <typename S>
struct StatorModes {
  S mass;          ///< m_s of each mode, for the displacement at the contact radius [kg]
  S resonance;     ///< 2 pi f_r of the free stator [rad/s]
  S damping;       ///< d_s [N s/m]
  S force_factor;  ///< Theta of a phase [N/V]
  S capacitance;   ///< C_0 of a phase [F]
  S loss_tangent;  ///< tan delta of C_0 [1]
};

/// The modes of a design; nothing if it does not say enough of them.
inline std::optional<StatorModes<double>> stator_modes(const MotorDesign& design) {
  if (!has_modal_data(design)) return {};
  const auto value = [&](Parameter parameter) { return get(design, parameter); };
  return StatorModes<double>{value(Parameter::modal_mass),
                             2 * std::numbers::pi * value(Parameter::resonance_frequency),
                             modal_damping(design),
                             value(Parameter::force_factor),
                             value(Parameter::blocked_capacitance),
                             value(Parameter::loss_tangent)};
}

/// k_s - omega^2 m_s, without the cancellation of its two terms [N/m].
template <typename S>
S dynamic_stiffness(const StatorModes<S>& m, const S& omega) {
  return m.mass * (m.resonance - omega) * (m.resonance + omega);
}

/// R + i I, the force that a wave takes of the drive in the wave's own frame (D2.3) [N].
template <typename S>
struct WaveBalance {
  S real, imaginary;

  /// H, the size of the force.
  S force() const {
    using std::sqrt;
    return sqrt(real * real + imaginary * imaginary);
  }
};

/// R and I of a wave of an amplitude whose contact acts on it with Re F and takes P_in (D1.2, D2.3).
template <typename S>
WaveBalance<S> wave_balance(const StatorModes<S>& m, const S& amplitude, const S& omega,
                            const S& reactive_force, const S& stator_power) {
  const S velocity = omega * amplitude;
  return {dynamic_stiffness(m, omega) * amplitude + reactive_force,
          m.damping * velocity + stator_power / velocity};
}

/// What the terminals see of a wave. Powers are those of both phases together, voltage and current those of one.
template <typename S>
struct Terminals {
  S voltage;          ///< that holds the wave, rms [V]
  S current;          ///< rms [A] (D4.1)
  S dielectric_loss;  ///< in C_0 [W]
  S power;            ///< P_el [W] (D4.2)
  S power_factor;     ///< (D4.3) [1]
};

template <typename S>
Terminals<S> terminals(const StatorModes<S>& m, const WaveBalance<S>& w, const S& amplitude,
                       const S& omega) {
  using std::sqrt;
  const S velocity = omega * amplitude, force = w.force(), voltage = force / m.force_factor;
  const S susceptance = omega * m.capacitance;
  const S motional = m.force_factor * velocity / force;  // current per R + i I
  const S active = susceptance * m.loss_tangent * voltage + motional * w.imaginary;
  const S reactive = susceptance * voltage + motional * w.real;
  const S current = sqrt(active * active + reactive * reactive), rms(std::sqrt(0.5));
  const S dielectric = susceptance * m.loss_tangent * voltage * voltage;
  return {rms * voltage, rms * current, dielectric, dielectric + velocity * w.imaginary,
          active / current};
}

}  // namespace twum::performance
