// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/backward_wave.hpp>
#include <twum/core/zone.hpp>

#include <vector>

namespace twum::inline v0_1 {

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
  /// At the inverter, which without driver_inductance and driver_resistance is at the terminals; NaN without modal data. Powers are
  /// those of both phases together, voltage and current those of one phase, rms.
  /// @{
  double phase_lag{0};  ///< phi of the wave behind the voltage (D2.4) [rad]
  double voltage{0};    ///< of the inverter that maintains the wave [V]
  /// The larger of the two phases (D4.1, D6.6) [A]. It and the power factor are NaN if phases or modes are unequal
  /// and the backward wave is not known.
  double phase_current{0};
  double dielectric_loss{0};   ///< loss in the blocked capacitances [W]
  double electrical_power{0};  ///< P_el = P_diel + P_stator + P_in + P_driver (D4.2, D8.5) [W]
  double power_factor{0};      ///< (D4.3) [1]
  double driver_loss{0};       ///< P_driver, loss in driver_resistance (D8.5) [W]
  /// Across a phase, behind the driver's inductance and resistance; the larger of the two phases, NaN as the current [V].
  double terminal_voltage{0};
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
  double radial_velocity;  ///< of the stator's surface (R1.1), 0 without radial_motion [m/s]
  double radial_traction;  ///< on the layer, outward [Pa]
};

/// Fields along one wave in the periodic state, at one radius of the contact track.
struct ContactFields {
  OperatingPoint point;              ///< operating point of the whole motor
  double radius{0};                  ///< radius of the fields [m]
  std::vector<Zone> zones;           ///< from contact entry to exit
  std::vector<FieldSample> samples;  ///< ordered by phase
};

}  // namespace twum::inline v0_1
