// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motor_design.hpp>

#include <complex>
#include <vector>

namespace twum::test {

/// A driven motor integrated in time: the equations of its two standing waves, and at each of many places of the rotor a layer
/// that is pressed, sheared and slips by Coulomb's law. Knows no wave, no phase and no average.
///
/// For elastic layers with mu_0 = mu. Without a rotor mass the rotor's face balances the preload at every instant. Phases and modes
/// may be unequal. The modes' own motion is exact
/// (as a rotation that decays), drive and contact act in kicks of half a step before and after (Strang's splitting); where a place begins or ends to slip the step errs in the first order.
class TwoModes {
 public:
  static constexpr int kPlaces = 100;  ///< of the rotor, on one wavelength
  static constexpr int kSteps = 400;   ///< per period of the drive

  /// @param design  with a voltage
  TwoModes(const MotorDesign& design, double speed);

  /// From here on another frequency of the drive [Hz]; its phase goes on.
  void set_frequency(double frequency);
  void set_voltage(double rms) { drive_ = rms * drive_per_volt_; }
  /// Adds a damping of waves that run backward; a steady forward wave does not feel it [N s/m].
  void damp_backward_waves(double damping) { backward_damping_ = damping; }
  /// Adds a small wave that runs backward [m].
  void add_backward_wave(double amplitude);
  /// Begins with a forward wave of an amplitude that lags behind the voltage by a phase.
  void set_wave(double amplitude, double phase_lag);
  void run(int periods);

  /// Amplitude and minus phase lag of the forward wave, mean over the last run.
  std::complex<double> wave() const { return wave_; }
  /// Amplitude of the backward wave: mean over the last run, of one at the drive's frequency, and root mean square, of any.
  double forced_backward() const { return std::abs(backward_); }
  double any_backward() const { return any_backward_; }
  /// Root mean squares of the velocities of the two modes over the last run [m/s].
  double cosine_velocity() const { return rate_[0]; }
  double sine_velocity() const { return rate_[1]; }
  /// Mean torque and power from the stator to the layer over the last run.
  double torque() const { return torque_; }
  double stator_power() const { return stator_power_; }

 private:
  using Complex = std::complex<double>;

  void step();
  void kick(double duration);
  void press();
  void place_rotor();
  void shear(Complex moved);
  double height_that_carries() const;
  Complex backward_velocity() const;

  // (w_c, w_s) as real and imaginary part.
  Complex place_{0, 0}, velocity_{0, 0}, force_{0, 0};
  double phase_{0};  // of the drive [rad]
  double speed_, omega_, step_;
  double mass_, decay_;
  double own_[2];  // damped frequencies of the two modes
  double voltage_ratio_{1}, phase_error_{0};
  double rotor_mass_{0}, lift_{0}, pressed_{0};  // speed of the rotor's face, force on it
  double drive_{0}, drive_per_volt_, backward_damping_{0};
  double tilt_, foundation_, shear_, friction_, preload_, area_, radius_, wave_number_;
  double height_{0}, rotor_{0};
  std::vector<Complex> turn_;  // exp(i kappa x) of each place on the rotor
  std::vector<double> pressure_, traction_;
  Complex wave_{0, 0}, backward_{0, 0};
  double any_backward_{0}, rate_[2]{0, 0};
  double torque_{0}, stator_power_{0};
  double torque_now_{0}, power_now_{0};
};

}  // namespace twum::test
