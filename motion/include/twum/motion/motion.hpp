// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motor_design.hpp>
#include <twum/motion/profile.hpp>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace twum::inline v0_1::motion {

/// How a motion is computed.
enum class MotionEngine : unsigned char {
  averaged,    ///< one wave, averaged over each vibration
  oscillating  ///< both modes, the rotor and the points of its face in each vibration
};
/// As in a study file; static lifetime.
const char* to_string(MotionEngine value) noexcept;

/// How the averaged engine takes the rotor's axial position.
enum class AxialMotion : unsigned char {
  balanced,  ///< the preload holds it where the contact carries it, at every instant
  dynamic    ///< it moves by its mass and damping (M4.5)
};
/// "static" or "dynamic", as in a study file; static lifetime.
const char* to_string(AxialMotion value) noexcept;

/// From one time to another [s].
struct Interval {
  double begin;  ///< [s]
  double end;    ///< [s]
};

/// State of a motor in motion at the beginning.
struct InitialState {
  /// The steady running state under the first values of drive and load; the others are then ignored.
  bool steady{false};
  double speed{0};      ///< Omega [rad/s]
  double amplitude{0};  ///< A of the wave [m], of a motor under a voltage
  double phase_lag{0};  ///< phi behind the voltage [rad]
  double angle{0};      ///< theta_r [rad]
};

/// What is done to a motor over time. Inertia and friction of rotor and load are those of the design.
struct MotionTask {
  double duration{0};                    ///< [s]
  InitialState initial{};                ///< at rest, the layer relaxed
  Profile voltage{};                     ///< of each phase, rms [V], of a motor under a voltage
  Profile amplitude{};                   ///< A of the wave [m], of a motor with a given amplitude
  Profile frequency{};                   ///< f of the drive [Hz]
  Profile load_torque{};                 ///< T_L against positive motion [N m]
  std::vector<Interval> switched_off{};  ///< when the drive is off; phases then have off_resistance
  std::vector<Interval> reversed{};      ///< when phases are swapped: the wave runs backward
  MotionEngine engine{MotionEngine::averaged};  ///< how it is computed
  /// Of the averaged engine; the other one takes the mass.
  AxialMotion axial{AxialMotion::balanced};
  /// Lead of the first phase before the second [rad]; other than a quarter of a turn with the oscillating engine only
  Profile phase_difference{std::numbers::pi / 2};
  /// Of the oscillating engine: 1, 2 or 4; 0.5 to compare with. It multiplies points of the contact and steps of a period.
  double accuracy{1};
  std::vector<double> output_times{};  ///< times of the samples, rising [s]; may be empty
  double tolerance{1.5e-7};            ///< of the integration, relative
  /// Asked some hundred times a second, with the time that is reached [s]; false ends the motion as `stopped`. May be empty.
  std::function<bool(double)> go_on{};
};

/// A motor at one time of a motion. SI units.
struct MotionSample {
  double time{0};         ///< [s]
  double voltage{0};      ///< at the terminals of a phase, rms [V]; NaN with a given amplitude
  double frequency{0};    ///< f [Hz]
  double load_torque{0};  ///< T_L [N m]
  double amplitude{0};    ///< A [m]
  double phase_lag{0};    ///< phi behind the voltage [rad]; NaN with a given amplitude
  /// Of the wave against the first one [m]; NaN with the averaged engine
  double backward_amplitude{std::numeric_limits<double>::quiet_NaN()};
  double phase_difference{std::numbers::pi / 2};  ///< between the phases [rad]
  double speed{0};                                ///< Omega [rad/s]
  double angle{0};                                ///< theta_r [rad]
  double torque{0};          ///< T of the contact on the rotor; held, what holds the load [N m]
  double stator_power{0};    ///< P_in, from the stator to the layer [W]
  double friction_power{0};  ///< P_fric [W]
  /// Both phases, positive into the motor [W]; NaN without modal data.
  double electrical_power{0};
  double phase_current{0};  ///< of a phase, rms [A]; NaN without modal data
  double energy{0};         ///< electrical energy since the beginning [J]
  bool held{false};         ///< the contact holds the rotor at rest
  bool off{false};          ///< the drive is off

  /// Amplitude of the larger wave [m].
  double larger_wave() const { return std::fmax(amplitude, backward_amplitude); }
};

/// What happened at one time of a motion.
enum class MotionEventKind : unsigned char {
  held,        ///< the rotor came to rest, and the contact holds it
  released,    ///< the contact no longer holds the rotor
  reversed,    ///< the rotor passed rest and turns the other way
  started,     ///< the wave rose through 3 A_1
  pulled_out,  ///< the driven wave fell below a third of its largest amplitude, and below 3 A_1
  overruns,    ///< the rotor drives the wave: T below -1 % of the holding torque at a forward speed
  switched_off,  ///< the drive
  switched_on,   ///< likewise
  swapped,       ///< the phases, so that the wave changed its direction
  squeals,  ///< a backward wave, which an averaged motion leaves out, has grown 150-fold (add_what_is_left_out())
  bounces,  ///< likewise hops of the rotor
  too_fast  ///< wave and rotor change within 30 rad of the wave's phase, about five turns (add_what_is_left_out())
};

/// Short machine-readable word, such as "pulled-out". Static lifetime.
const char* to_string(MotionEventKind kind) noexcept;

/// An event with the state in which it happened.
struct MotionEvent {
  MotionEventKind kind;  ///< what happened
  double time;           ///< [s]
  double speed;          ///< Omega [rad/s]
  double angle;          ///< theta_r [rad]
  double amplitude;      ///< A [m]
};

/// A motion that was computed, up to `end`.
struct Motion {
  std::vector<MotionSample> samples;  ///< at the output times up to `end`
  std::vector<MotionEvent> events;    ///< in the order of time
  MotionSample last;                  ///< at `end`
  /// Omega of the largest size, between samples, too; with the oscillating engine that of a period [rad/s].
  double fastest{0};
  /// "ok"; a word of PointStatus where the contact has no answer; "swap-too-early" where phases were swapped at an amplitude of
  /// 2 A_1 or more; "integrator-failed"; "stopped" by go_on
  std::string status{"ok"};
  double end{0};     ///< time that was reached, the duration if the status is ok [s]
  long steps{0};     ///< of the integrator
  long contacts{0};  ///< contacts that the integration solved, without those of samples and events
};

/// The task of a drive that stands still: the design's voltage, or amplitude, and frequency at all times.
MotionTask steady_drive(const MotorDesign& design, double duration);

/// A_1, amplitude at which the contact opens, if all of it lies at the contact radius (D1.5) [m].
double opening_amplitude(const MotorDesign& design);

/// Finds a steady beginning and the mode of the rotor, without a motion.
/// @throws InputError as simulate()
void require_motion(const MotorDesign& design, const MotionTask& task);

/// Follows a motor in time. The averaged engine integrates the averaged wave, the rotor and the load (M2.1, M2.2), with the contact of an operating point at
/// each instant, and a rotor that rests where friction holds it (M4.1). About 2 microseconds a contact with one slice, and some 50
/// contacts a millisecond of a start. The layer's viscosity stays that of the design's frequency.
/// The oscillating engine integrates both modes, the rotor and the points of its face in each vibration, with unequal phases and
/// modes as well; samples are then means over a period of the drive. About 2 ms of processor time a millisecond at an accuracy of
/// 1, and 20 at 4.
/// A motion that ends early is a result with a status.
/// @throws InputError for a design without rotor_inertia and for a task that is not admissible; averaged: without an integrator,
///         for unequal phases or modes, and with an axial motion without rotor_mass or with slices; oscillating: without a voltage, with slices, a taper or mu_0 > mu, and without
///         rotor_mass if the phase difference is not 90 degrees.
Motion simulate(const MotorDesign& design, const MotionTask& task);

}  // namespace twum::inline v0_1::motion
