// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motor.hpp>

#include <complex>

namespace twum::motion {

using Complex = std::complex<double>;
inline constexpr Complex kI{0, 1};

/// The numbers of a motor that stay the same during a motion.
struct MotionModel {
  /// @throws InputError for a design without rotor_inertia, or with unequal phases or modes.
  explicit MotionModel(const MotorDesign& design);

  /// Theta u_0 of a voltage, rms [N].
  double drive_force(double voltage) const;
  /// Terminal voltage of a phase per displacement of the wave while the drive is off [V/m] (M3.2 at V = 0).
  Complex off_voltage(double omega) const;
  /// Torque of the load's spring [N m].
  double spring(double angle) const { return stiffness * (angle - neutral); }

  Motor motor;                                       ///< with a given amplitude, its slices fixed
  bool driven;                                       ///< under a voltage
  double mass{0}, damping{0}, stiffness_of_wave{0};  ///< m_s, d_s, k_s
  double force_factor{0}, capacitance{0}, loss_tangent{0};          ///< Theta, C_0, tan delta
  double inertia, load_damping, load_friction, stiffness, neutral;  ///< J, c_L, T_c, k_L, theta_0
  double off_resistance;                                            ///< R_off
  double full_contact_amplitude;                                    ///< A_1 (D1.5)
  double holding_torque;                                            ///< T7.8
  bool mirrors_at_rest;        ///< T(0-) = |T(0+)|: an undamped layer at one radius (M4.2)
  double crest_per_amplitude;  ///< V0 / (r omega A) [1/m]
};

}  // namespace twum::motion
