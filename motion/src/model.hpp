// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motor.hpp>

#include <complex>

namespace twum::inline v0_1::motion {

using Complex = std::complex<double>;
inline constexpr Complex kI{0, 1};

/// The numbers of a motor that stay the same during a motion.
struct MotionModel {
  /// @throws InputError for a design without rotor_inertia, or with unequal phases or modes.
  explicit MotionModel(const MotorDesign& design);

  /// A driver with an inductance or a resistance in series: the terminals then have states of their own (M3.1).
  bool has_series() const { return series_inductance != 0 || series_resistance != 0; }
  /// i omega C_0 (1 - i tan delta) [1/ohm].
  Complex capacitive_admittance(double omega) const {
    return kI * omega * capacitance * Complex{1, -loss_tangent};
  }
  /// Theta u_0 of a voltage, rms [N].
  double drive_force(double voltage) const;
  /// Terminal voltage of a phase per displacement of the wave while the drive is off [V/m] (M3.2 at V = 0).
  Complex off_voltage(double omega) const;
  /// Torque of the load's spring [N m].
  double spring(double angle) const { return stiffness * (angle - neutral); }

  /// Normal force of a rotor whose face is at a height over the mean surface of the stator (T3.1, T3.3) [N]; at one radius.
  double normal_force(double amplitude, double height) const;
  /// Its derivatives (C21.7) [N/m].
  struct NormalSlopes {
    double per_amplitude, per_height;
  };
  NormalSlopes normal_slopes(double amplitude, double height) const;
  /// Height at which it is the preload [m].
  double balanced_height(double amplitude) const;

  Motor motor;                                       ///< with a given amplitude, its slices fixed
  bool driven;                                       ///< under a voltage
  double mass{0}, damping{0}, stiffness_of_wave{0};  ///< m_s, d_s, k_s
  double force_factor{0}, capacitance{0}, loss_tangent{0};          ///< Theta, C_0, tan delta
  double inertia, load_damping, load_friction, stiffness, neutral;  ///< J, c_L, T_c, k_L, theta_0
  double off_resistance;                                            ///< R_off
  double series_inductance{0}, series_resistance{0};                ///< L_s, R_s
  double rotor_mass, axial_damping;                                 ///< m_r, 0 if not given; d_z
  double bed_stiffness;                                             ///< 2 r b E / h [N/m]
  double full_contact_amplitude;                                    ///< A_1 (D1.5)
  double holding_torque;                                            ///< T7.8
  bool mirrors_at_rest;        ///< T(0-) = |T(0+)|: an undamped layer at one radius (M4.2)
  double crest_per_amplitude;  ///< V0 / (r omega A) [1/m]
};

}  // namespace twum::inline v0_1::motion
