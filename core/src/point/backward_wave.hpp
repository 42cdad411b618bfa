// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/lap.hpp"
#include "model/motor_model.hpp"
#include "model/phasor.hpp"
#include "model/stator_modes.hpp"

#include <optional>

namespace twum::inline v0_1::core {

/// A zone of a contact that a small backward wave disturbs.
template <typename S>
struct DisturbedZone {
  ZoneState state;
  /// of a stick zone: a slip zone precedes it; otherwise the contact begins with it
  bool after_slip;
  double sign;  ///< zeta of this zone if it slips, of the zone before if it sticks
  S from, to;   ///< [rad]
};

/// Numbers of a contact at one radius that determine its response to a backward wave (D6.2 to D6.4).
template <typename S>
struct DisturbedSlice {
  S stiffness;   ///< pi rho R drho E / h, per displacement of the surface [N/m]
  S shape;       ///< R
  S half_angle;  ///< theta_L
  S tilt;        ///< a n / rho
  S kinetic;     ///< mu
  S shear;       ///< G / E
  S entry_rate;  ///< (G / E) (V0 cos theta_L - U) / (W A R sin theta_L): layer strained where the contact begins to stick
  Vector<DisturbedZone<S>> zones;
};

/// The contact of a whole motor at an operating point, as it acts on a backward wave.
template <typename S>
struct DisturbedContact {
  S wave_rate;  ///< W [rad/s]
  S omega;      ///< of the drive [rad/s]
  Vector<DisturbedSlice<S>> slices;
};

/// The contact of an operating point in double. Nothing where the theory has no answer: if the layer sticks somewhere
/// and has damping or inertia, or mu_0 > mu, or the contact is full; and for a motor without a wave.
std::optional<DisturbedContact<double>> disturbed_contact(const DrivenMotor<double>& motor,
                                                          double speed);

/// The same with derivatives: the zones of the contact in double, with the derivatives of their borders.
template <typename S>
DisturbedContact<S> moved_contact(const DrivenMotor<S>& motor, const S& speed,
                                  const DisturbedContact<double>& value);

/// Stiffness of the contact against a backward wave of frequency omega' (D6.2 to D6.4) [N/m].
template <typename S>
Phasor<S> backward_stiffness(const DisturbedContact<S>& contact, const S& frequency,
                             const std::optional<S>& rotor_mass) {
  using std::sin, std::cos;
  const S beat = contact.omega + frequency;
  // The rotor follows the mean of the disturbed pressure (D6.2).
  S pushed(0.0), held(0.0);
  for (const DisturbedSlice<S>& s : contact.slices) {
    const S per_shape = s.stiffness / (std::numbers::pi * s.shape);
    pushed = pushed + 2.0 * (per_shape * s.shape * sin(s.half_angle));
    held = held + 2.0 * (per_shape * s.half_angle);
  }
  if (rotor_mass) held = held - *rotor_mass * beat * beat;
  const S lift = pushed / held, nu = beat / contact.wave_rate - 1.0;
  Phasor<S> sum{S(0.0), S(0.0)};
  for (const DisturbedSlice<S>& s : contact.slices) {
    const auto f = [&](const S& theta) {
      return Phasor<S>{s.shape - lift * cos(theta), lift * sin(theta)};
    };
    const S strain = s.shear * s.tilt * s.shape * (frequency / contact.wave_rate);
    Phasor<S> pressure{S(0.0), S(0.0)}, traction{S(0.0), S(0.0)};
    for (const DisturbedZone<S>& zone : s.zones) {
      const S length = zone.to - zone.from;
      const Phasor<S> normal{s.shape * length - lift * (sin(zone.to) - sin(zone.from)),
                             lift * (cos(zone.from) - cos(zone.to))};
      pressure = pressure + normal;
      if (zone.state != ZoneState::stick) {
        traction = traction + S(zone.sign * s.kinetic) * normal;
        continue;
      }
      const Phasor<S> first =
          zone.after_slip ? S(zone.sign * s.kinetic) * f(zone.from) : s.entry_rate * f(zone.from);
      // E = (e^(i nu L) - 1) / (i nu), and its integral over the zone
      const S turn = nu * length;
      const Phasor<S> spread{sin(turn) / nu, (1.0 - cos(turn)) / nu};
      const Phasor<S> twice{spread.imaginary / nu, (length - spread.real) / nu};
      traction = traction + first * spread - strain * twice;
    }
    const Phasor<S> both{pressure.real - s.tilt * traction.imaginary,
                         pressure.imaginary + s.tilt * traction.real};
    sum = sum + (s.stiffness / (2 * std::numbers::pi)) * both;
  }
  return sum;
}

/// z of the backward wave that unequal phases and modes drive (D6.5, D8.6) [m].
/// @param w  inverter_balance()
template <typename S>
Phasor<S> forced_backward_wave(const DisturbedContact<S>& contact, const StatorModes<S>& m,
                               const WaveBalance<S>& w, const S& amplitude) {
  const S force = w.force(), omega = contact.omega, share = m.unequal.share();
  Phasor<S> driven = S(force / share) * m.unequal.backward();
  const Phasor<S> lag =
      (1.0 / (force * share)) * (Phasor<S>{w.real, w.imaginary} * m.unequal.forward().conjugate());
  const S split = m.mass * m.resonance * m.resonance * m.unequal.mode_splitting * amplitude;
  Phasor<S> stiffness = backward_stiffness(contact, omega, m.rotor_mass) +
                        Phasor<S>{dynamic_stiffness(m, omega), -(omega * m.damping)};
  if (m.has_series()) {  // it turns the other way
    const SeriesAction<S> a = series_action(m, omega);
    driven = driven / a.blocked.conjugate();
    stiffness = stiffness + a.stiffness().conjugate();
  }
  return (driven - split * lag) / stiffness;
}

/// The free backward wave (D6.7).
template <typename S>
struct FreeBackwardWave {
  S frequency;  ///< [rad/s]
  S rate;       ///< at which it grows [1/s]
  S damping,
      mass;  ///< without the contact: d_s and m_s, with a series branch those of (D8.6) [N s/m, kg]
};

template <typename S>
FreeBackwardWave<S> free_backward_wave(const DisturbedContact<S>& contact,
                                       const StatorModes<S>& modes,
                                       const std::optional<S>& rotor_mass) {
  using std::sqrt;
  const S stator = modes.mass * modes.resonance * modes.resonance;
  S frequency = contact.omega;
  Phasor<S> stiffness{S(0.0), S(0.0)};
  // The contact hardly depends on the frequency, so each step gains two digits, also in derivatives.
  constexpr int kSteps = 14;
  S damping = modes.damping, mass = modes.mass;
  for (int i = 0; i < kSteps; ++i) {
    stiffness = backward_stiffness(contact, frequency, rotor_mass);
    if (!modes.has_series()) {
      frequency = sqrt(S((stator + stiffness.real) / modes.mass));
      continue;
    }
    const Phasor<S> beta = series_action(modes, frequency).stiffness();
    mass = modes.mass - series_mass(modes, frequency);
    damping = modes.damping + beta.imaginary / frequency;
    const S square = frequency * frequency;
    frequency =
        sqrt(S(square + (stator + stiffness.real + beta.real - modes.mass * square) / mass));
  }
  const S twice = 2.0 * mass;
  return {frequency, stiffness.imaginary / (twice * frequency) - damping / twice, damping, mass};
}

}  // namespace twum::inline v0_1::core
