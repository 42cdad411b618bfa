// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/contact/normal_contact.hpp>
#include <twum/core/contact/zone.hpp>
#include <twum/core/design/motor_design.hpp>
#include <twum/core/performance/backward_wave.hpp>

#include <memory>
#include <vector>

namespace twum {

namespace performance {
template <typename S>
struct DrivenMotor;
template <typename S>
struct StatorModes;
class Drive;
struct MotorPoint;
}  // namespace performance

/// Whether an operating point has an answer.
enum class PointStatus : unsigned char {
  ok,
  no_periodic_state,  ///< the motion of the layer does not become periodic (typical: mu_0 > mu)
  /// the motion neither settles nor repeats within the largest number of periods (undamped layers)
  not_converged,
  resonance,   ///< undamped layer driven at its own resonance: no finite response
  unresolved,  ///< more stick and slip zones than can be followed
  inaccurate,  ///< rounding errors violate a law of the model, so no number is reliable
  pulled_out,  ///< a motor under a voltage has no running wave at this speed, but has one at others
  no_running_branch,  ///< a motor under a voltage has no running wave at any speed
  no_dead_branch,     ///< a motor under a voltage has no dead wave here: it starts by itself
  unstable_amplitude  ///< the wave that was asked for is not stable
};

/// Short machine-readable word, such as "no-periodic-state"; "ok" for ok. Static lifetime.
const char* to_string(PointStatus status) noexcept;

/// What is prescribed at an operating point, beside the design.
struct OperatingConditions {
  double speed{0};      ///< Omega of the rotor [rad/s]
  double amplitude{0};  ///< A of the wave [m]
  double frequency{0};  ///< f of the wave [Hz]
};

/// The motor in its periodic state at one rotor speed. SI units; theory section 7.
///
/// If status is ok, all numbers are finite (those of the terminals only if the design has modal data). The powers
/// then balance (T7.10) to 1e-6 of mu_0 F_N max(V0, |U|) (T7.11), losses are above -1e-9 of that, and |T| <= mu_0 F_N
/// r (C8.1) holds to 1e-9. All motors tested keep these laws to 1e-10. If status is not ok, every number but `speed`
/// is NaN.
struct OperatingPoint {
  double speed{0};         ///< Omega [rad/s]
  double torque{0};        ///< T on the rotor, positive in drive direction [N m]
  double output_power{0};  ///< P_out = T Omega [W]
  double stator_power{0};  ///< P_in, from the stator to the layer [W]
  /// P_fric, including sudden releases of the layer [W], >= 0 up to rounding
  double friction_power{0};
  double layer_loss{0};      ///< P_layer, viscous loss in the layer [W], >= 0 up to rounding
  double stator_loss{0};     ///< P_stator = c_stator (omega A)^2 [W]
  double wear_intensity{0};  ///< P_fric / (2 pi r b) [W/m^2]
  double stick_fraction{0};  ///< share of the contact length that sticks [1]
  double reactive_force{0};  ///< Re F, the contact's force on the wave in phase with it (D1.1) [N];
                             ///< Im F = P_in / (omega A) (D1.2)
  double amplitude{0};       ///< A of the wave [m]
  /// At the terminals; NaN without modal data. Powers are those of both phases together, voltage and current those of
  /// one phase, rms.
  /// @{
  double phase_lag{0};  ///< phi of the wave behind the voltage (D2.4) [rad]
  double voltage{0};    ///< that maintains the wave [V]
  /// The larger of the two phases (D4.1, D6.6) [A]. It and the power factor are NaN if phases or modes are unequal
  /// and the backward wave is not known.
  double phase_current{0};
  double dielectric_loss{0};   ///< loss in the blocked capacitances [W]
  double electrical_power{0};  ///< P_el = P_diel + P_stator + P_in (D4.2) [W]
  double power_factor{0};      ///< (D4.3) [1]
  /// @}
  PointStatus status{PointStatus::ok};  ///< ok, or why there is no answer

  /// P_out / P_el (D4.3), 0 where the output is negative; NaN where P_el is not positive or not known [1]
  double overall_efficiency() const noexcept;
  /// P_out / P_in where P_in > 0 and the power balance holds to 1e-8 of P_in, else NaN [1]
  double contact_efficiency() const noexcept;
  /// P_out / (P_in + P_stator) where that sum is > 0 and the power balance holds to 1e-8 of it, else NaN [1]
  double efficiency() const noexcept;
};

/// A steady wave under a voltage at a speed: a solution of the force balance of the wave.
struct WaveState {
  double amplitude;    ///< A [m]
  double phase_lag;    ///< phi behind the voltage [rad]
  double determinant;  ///< of the slow flow (D2.6) [1/s^2]
  double trace;        ///< of the slow flow (D2.6) [1/s]
  bool stable;         ///< a disturbed wave returns to it
  /// stable and on the branch of a running motor (theory of the driven stator, section 2)
  bool running;
};

/// State of the contact at one phase of the wave; theory sections 2 to 4.
struct FieldSample {
  double phase;            ///< theta, crest at 0 [rad], -pi .. pi
  double pressure;         ///< p [Pa]
  double traction;         ///< tau on the layer, positive in drive direction [Pa]
  double displacement;     ///< h eps, of the layer surface against the rotor [m]
  double stator_velocity;  ///< v_s [m/s]
  double layer_velocity;   ///< v_r [m/s]
};

/// Fields along one wave in the periodic state, at one radius of the contact track.
struct ContactFields {
  OperatingPoint point;              ///< operating point of the whole motor
  double radius{0};                  ///< radius of the fields [m]
  std::vector<Zone> zones;           ///< from contact entry to exit
  std::vector<FieldSample> samples;  ///< ordered by phase
};

/// A motor: its design and everything that follows from the design alone. Immutable, so any number of threads may use
/// one Motor.
///
/// Under a voltage the amplitude depends on the load. contact() and crest_speed(), which do not depend on speed for a
/// given amplitude, then belong to the wave at first_speed().
class Motor {
 public:
  /// Solves the normal contact (T3.1 to T3.4; W2.1 to W2.4). About a microsecond, 20 for 8 slices, and a
  /// millisecond for `auto`, which tries how many nodes are needed. Under a voltage it follows the running wave
  /// over speed, which takes some hundred operating points.
  /// @throws InputError with every complaint about the design.
  explicit Motor(const MotorDesign& design);

  /// The design as it was given.
  const MotorDesign& design() const noexcept { return design_; }
  /// Pressure between wave and rotor at the contact radius, the same at every speed (T3.1 to T3.4, W2.2).
  const NormalContact<double>& contact() const noexcept;

  /// The design's radial_slices; where it is kAutoSlices, -N with the number N of nodes a panel that `auto` chooses for it.
  /// `with(design, Parameter::radial_slices, motor.radial_slices())` fixes them while the design moves.
  int radial_slices() const noexcept;
  /// False if `auto` has given up the search for the number of slices that 1e-6 takes, and has taken as many as it may.
  bool slices_settled() const noexcept;
  /// Radii of the slices that touch, in rising order [m]; the contact radius alone if there is one slice. With `auto`, those where
  /// no zone appears along the track.
  std::vector<double> slice_radii() const;

  /// Smallest rotor speed of the curve: 0, or where the running wave of a motor under a voltage begins [rad/s].
  double first_speed() const;

  /// V0 / r, rotor speed that matches the crest velocity of the stator surface [rad/s].
  double crest_speed() const noexcept;
  /// v_w / r; rotor speeds must exceed its negative [rad/s].
  double wave_speed() const noexcept;
  /// mu_0 F_N r (T7.8), over an annulus (W3.6): torque at rest without drive; for one slice the bound of every torque [N m].
  double holding_torque() const noexcept;
  /// True if the whole contact sticks at rest, the motor being locked like a brake; theory section 10.
  bool locks_at_rest() const noexcept;

  /// Periodic state at a rotor speed [rad/s], by the closed forms of T4.1 to T4.5. About a microsecond,
  /// no heap allocation.
  /// Smooth in speed where zones neither appear nor vanish, C1 there if mu_0 = mu.
  /// @throws InputError unless speed > -wave_speed() (and finite).
  OperatingPoint operating_point(double speed) const;

  /// The same for a wave with another amplitude and frequency than the design's. The layer's viscosity stays that of
  /// the design, even if it follows from a loss factor at the design's frequency.
  /// @throws InputError as above, and for an amplitude or a frequency outside its range.
  OperatingPoint operating_point(const OperatingConditions& at) const;

  /// Stick and slip zones at the contact radius at a rotor speed [rad/s] from contact entry to exit; empty if the point has
  /// no answer. About a microsecond a slice.
  /// @throws InputError as operating_point().
  std::vector<Zone> zones(double speed) const;
  /// The same at another radius of the contact track, not necessarily that of a slice. With one slice the zones are
  /// the same at all radii.
  /// @param radius  [m]
  /// @throws InputError as operating_point(), and for a radius outside the track.
  std::vector<Zone> zones(double speed, double radius) const;

  /// Fields at the contact radius at a rotor speed [rad/s] at `samples` equally spaced phases over one wave (no
  /// samples are added at the borders of zones). Pressure is continuous; traction may jump at the borders.
  /// @param samples  at least 2
  /// @throws InputError as operating_point(), and for fewer samples.
  ContactFields fields(double speed, int samples) const;
  /// The same at another radius of the contact track, as zones().
  /// @param radius  [m]
  /// @throws InputError as above, and for a radius outside the track.
  ContactFields fields(double speed, int samples, double radius) const;

  /// The backward wave at a rotor speed [rad/s], all NaN where operating_point() has no answer. Some ten microseconds a slice.
  /// @throws InputError as operating_point().
  BackwardWave backward_wave(double speed) const;

  /// Every steady wave under the voltage at a rotor speed [rad/s], stable or not, smallest amplitude first (D2.4).
  /// Empty for a motor with a given amplitude.
  /// @throws InputError as operating_point().
  std::vector<WaveState> wave_states(double speed) const;

  /// The drive of a motor under a voltage, else null. Internal.
  const performance::Drive* drive() const noexcept { return drive_.get(); }
  /// The modes of the stator, null without modal data. Internal.
  const performance::StatorModes<double>* modes() const noexcept { return modes_.get(); }
  /// The model of the motor. Internal.
  const performance::DrivenMotor<double>& model() const noexcept { return *model_; }

 private:
  performance::MotorPoint solved(double speed) const;

  MotorDesign design_;
  // Immutable, shared by copies.
  std::shared_ptr<const performance::StatorModes<double>> modes_;
  std::shared_ptr<const performance::Drive> drive_;
  std::shared_ptr<const performance::DrivenMotor<double>> model_;
};

/// Operating points at the given speeds [rad/s], in their order. About a microsecond each.
/// @throws InputError as Motor::operating_point(), for the first speed that is out of range.
std::vector<OperatingPoint> torque_speed_curve(const Motor& motor,
                                               const std::vector<double>& speeds);

}  // namespace twum
