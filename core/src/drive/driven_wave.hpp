// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/stator_modes.hpp"
#include "point/point.hpp"

#include <optional>
#include <utility>

namespace twum::inline v0_1::core {

/// A motor at a speed: the wave there, and the contact under it.
struct MotorPoint {
  DrivenMotor<double> motor;
  SolvedPoint solved;
};

/// A wave of a prescribed amplitude at a speed, and what drives it there.
struct DrivenWave {
  double amplitude{0}, speed{0};
  WaveBalance<double> balance{0, 0};
  PointStatus status{PointStatus::ok};
  WarmStart start;   ///< for neighbouring waves
  long zones{0};     ///< number of zones followed in a slice to find it, a measure of cost
  double torque{0};  ///< on the rotor [N m]

  double force() const { return balance.force(); }
};

/// The same with its derivatives in amplitude at fixed speed.
struct SlopedWave {
  DrivenWave wave;
  WaveBalance<double> slope;  ///< R_A, I_A [N/m]
  double torque_slope{0};     ///< T_A [N]

  /// H H_A; zero at folds.
  double fold() const {
    return wave.balance.real * slope.real + wave.balance.imaginary * slope.imaginary;
  }
  double force_slope() const { return fold() / wave.force(); }  ///< H_A [N/m]
};

/// What is continued beside the amplitude.
enum class Continued : unsigned char { speed, frequency, voltage };

/// Determinant and trace of the Jacobian of the slow flow (D2.5, D2.6), which decide the stability of a wave.
struct Stability {
  double determinant, trace;  ///< [1/s^2], [1/s]
  bool stable() const { return determinant > 0 && trace < 0; }
};

/// A motor at one frequency with variable amplitude: the force that each amplitude and speed needs from the drive.
class DrivenWaves {
 public:
  /// @param design  without a voltage the drive force is zero, without modal data the stator has neither mass nor stiffness nor
  ///                loss. Its amplitude is ignored
  /// @param track   the same for all amplitudes, so that H(A) has no steps
  DrivenWaves(const MotorDesign& design, const TrackRule& track);

  /// The same motor at another drive frequency. If the layer's viscosity follows from a loss factor, it changes with
  /// the frequency.
  /// @param omega  [rad/s]
  DrivenWaves at_frequency(double omega) const;

  DrivenWave at(double amplitude, double speed, const WarmStart* guess = nullptr,
                double accuracy = 0) const;
  /// A solved wave, with derivatives in amplitude and in speed or frequency [rad/s], which takes the direction of the speed.
  struct MovingWave {
    PointNumbers<contact::MotionDual> numbers;
    MovingStates states;
    contact::MotionDual amplitude;
    WaveBalance<contact::MotionDual> balance;

    /// dA / dOmega along H(A, Omega) = Theta u_0 (D2.9).
    double amplitude_per_speed() const;
  };
  /// @param point  solved at this amplitude and speed
  MovingWave moving(const SolvedPoint& point, double amplitude, double speed,
                    Continued along = Continued::speed) const;
  /// With derivatives in amplitude.
  SlopedWave in_amplitude(double amplitude, double speed, const WarmStart* guess = nullptr) const {
    return slopes(amplitude, speed, guess).in_amplitude;
  }
  /// The same beside the derivatives along H(A, Omega) = Theta u_0 (D2.9).
  struct LevelSlopes {
    SolvedPoint solved;
    SlopedWave in_amplitude;
    PointNumbers<contact::MotionDual> numbers;
    double force_per_speed{0};                    ///< H_Omega, or H_omega along the frequency
    WaveBalance<double> balance_per_speed{0, 0};  ///< R and I likewise
    double amplitude_per_speed{0}, torque_per_speed{0};
    MovingStates states;
  };
  /// @param accuracy  of the periodic state, as find_periodic_state()
  /// @param near      a point with nearly the same speed and wave; null if none is known
  LevelSlopes slopes(double amplitude, double speed, const WarmStart* guess = nullptr,
                     double accuracy = 0, const SolvedPoint* near = nullptr,
                     Continued along = Continued::speed) const;
  /// The same of a wave that is solved.
  LevelSlopes slopes_of(SolvedPoint solved, double amplitude, double speed,
                        Continued along = Continued::speed) const;

  /// The force that a wave needs from the drive, from the numbers of its contact (D2.3, D8.3).
  WaveBalance<double> balance(const PointNumbers<double>& n, double amplitude) const {
    return drive_balance(modes_,
                         wave_balance(modes_, amplitude, omega_, n.reactive_force, n.stator_power),
                         amplitude, omega_);
  }
  /// @param half_angle  theta_L of one slice, if it is known
  DrivenMotor<double> motor(double amplitude, std::optional<double> half_angle = {}) const {
    return driven(model_, {amplitude, omega_}, half_angle);
  }
  Stability stability(const SlopedWave& wave) const;

  /// The track is split where zones begin.
  bool splits() const { return model_.track.splits; }
  /// mu_0 > mu: only laps from rest tell the contact's state, not a wave nearby.
  bool has_static_excess() const { return core::has_static_excess(model_); }
  const MotorModel<double>& model() const { return model_; }
  const StatorModes<double>& modes() const { return modes_; }
  /// phi of a wave behind the voltage (D2.4, D8.3) [rad].
  double phase_lag(const DrivenWave& wave) const;
  /// What a wave finds of stator and driver: k_s - omega^2 m_s + Re beta [N/m], d_s + Im beta / omega [N s/m], and 1 / |alpha|, force
  /// of the voltage over that on the wave (D8.2). @{
  double dynamic_stiffness() const;
  double damping() const;
  double divider() const;
  /// @}
  /// Of the free stator with the driver, at which dynamic_stiffness() is zero: that next to the modes' own [rad/s].
  double resonance() const { return resonance_; }
  /// Frequencies at which the stator's own resonance drives a wave, not that of a driver's inductance with C_0 (D8.7): above the first
  /// and below the second [rad/s].
  std::pair<double, double> own_side() const;
  double drive() const { return drive_; }
  double omega() const { return omega_; }
  /// V0 / r per amplitude [rad/s/m]
  double crest_speed_per_amplitude() const { return model_.tilt * omega_ / model_.r; }
  /// A_1 (D1.5), the amplitude up to which the contact is full if all of it lies at the contact radius [m].
  double full_contact_amplitude() const;
  /// Upper bound of the contact's force on the wave per amplitude: that of full contact that sticks all round [N/m].
  double contact_stiffness() const;
  /// mu_0 a kappa F_N, bound of the traction's force (C20.4, D2.10) [N].
  double traction_bound() const { return reach_ * model_.threshold * model_.tilt * model_.preload; }
  /// Bound of the pressure's force [N].
  double pressure_bound() const { return reach_ * model_.preload; }

 private:
  DrivenWave wave_of(const SolvedPoint& point, double amplitude, double speed) const;
  DrivenMotor<contact::MotionDual> moving_motor(const contact::MotionDual& amplitude,
                                                const contact::MotionDual& omega,
                                                std::optional<double> half_angle) const;

  MotorModel<double> model_;
  MotorModel<contact::MotionDual> dual_model_;
  StatorModes<double> modes_;
  double drive_;  // Theta u_0, the force of the voltage's peak [N]
  double omega_;
  double resonance_;
  std::optional<double> loss_factor_;  // if the layer's viscosity follows from it
  double reach_;                       // k of (D2.10)
};

}  // namespace twum::inline v0_1::core
