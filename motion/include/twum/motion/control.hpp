// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motor_design.hpp>
#include <twum/motion/linear_plant.hpp>
#include <twum/motion/motion.hpp>

#include <complex>
#include <optional>
#include <utility>
#include <vector>

namespace twum::inline v0_1::motion {

/// What a loop changes at the drive.
enum class Actuator : unsigned char { frequency, voltage };
/// As in a study file; static lifetime.
const char* to_string(Actuator value) noexcept;

/// Gains of a PI controller of the speed. Its output is a frequency [Hz] or a voltage, rms [V].
struct LoopGains {
  double proportional;  ///< kp [unit of the output s/rad]
  double integral;      ///< ki [unit of the output/rad]
};

/// A sampled loop of the speed, by the angle of an encoder.
struct SpeedControl {
  Profile reference{};                     ///< Omega_ref [rad/s], 0 or more
  double sample_time{1e-3};                ///< T_s [s]
  int delay{1};                            ///< whole samples from a measurement to its output
  std::optional<double> encoder{};         ///< counts a turn; without it the angle is exact
  Actuator actuator{Actuator::frequency};  ///< what the loop changes
  std::pair<double, double> range{};       ///< of the output [Hz or V]
  double start{0};                   ///< the output at the beginning, within the range [Hz or V]
  std::optional<double> slew{};      ///< largest change of the output over time [Hz/s or V/s]
  std::optional<LoopGains> gains{};  ///< without them those of (M8.1)
};

/// A sampled loop of the angle, which changes frequency and direction and switches the drive on and off.
struct PositionControl {
  Profile reference{};                ///< of theta_r [rad]
  double sample_time{1e-3};           ///< T_s [s]
  int delay{1};                       ///< whole samples from a measurement to its output
  double encoder{4000};               ///< counts a turn
  std::pair<double, double> range{};  ///< of the frequency [Hz]
  std::optional<double> slew{};       ///< largest fall of the frequency over time [Hz/s]
  /// Speed that is asked for over the way that is left [1/s]; without it 1 / (lambda + theta_d) as in (M8.1)
  std::optional<double> gain{};
  /// beta, share of the friction's deceleration that the speed asked for takes (M8.2); less where the motor coasts [1]
  double braking{0.5};
  double window{2};         ///< counts from the goal within which the drive stays off
  double off_time{1.5e-3};  ///< with the drive off before phases are swapped [s]
};

/// The motor as a loop of its speed sees it at one operating point.
struct LoopPlant {
  double output{0};  ///< of the loop: frequency [Hz] or voltage, rms [V]
  double speed{0};   ///< Omega [rad/s]
  double gain{0};  ///< K, steady change of the speed over that of the output [rad/s/Hz or rad/s/V]
  double time_constant{0};                    ///< tau, 1 / |Re p| of the slowest pole p [s]
  std::vector<std::complex<double>> poles{};  ///< the slowest first [1/s]
};

/// How far a loop is from instability. Infinite where nothing makes it unstable.
struct LoopMargins {
  double gain{0};   ///< factor of the gain at which it becomes unstable [1]
  double phase{0};  ///< lag at the crossover at which it becomes unstable [rad]
  double crossover{
      0};  ///< frequency at which the loop's gain falls through 1 [Hz]; 0 if it never is above
};

/// A motion under control, and what was known of the loop.
struct ControlledMotion {
  Motion motion{};        ///< what was computed
  LoopGains gains{};      ///< those in use
  LoopPlant plant{};      ///< where gains and margins were computed
  LoopMargins margins{};  ///< of the linear plant there
};

/// K and tau of a linear plant.
LoopPlant loop_plant(const LinearPlant& plant, Actuator actuator);

/// (M8.1) with lambda = 2 theta_d, theta_d = (delay + 1) T_s.
LoopGains loop_gains(const LoopPlant& plant, double sample_time, int delay);

/// A row of a gain schedule.
struct ScheduleRow {
  double output{0};                ///< frequency [Hz] or voltage, rms [V]
  std::optional<LoopPlant> plant;  ///< none where the motor does not run
  LoopGains gains{};               ///< of the plant
};

/// Plants and gains over outputs of a loop, under one load torque [N m].
/// @throws InputError for a motor with a given amplitude or without rotor_inertia
std::vector<ScheduleRow> gain_schedule(const MotorDesign& design, double load_torque,
                                       Actuator actuator, const std::vector<double>& outputs,
                                       double sample_time, int delay);

/// Margins of a sampled loop: the linear plant with a held input is discretised exactly.
LoopMargins loop_margins(const LinearPlant& plant, const SpeedControl& control,
                         const LoopGains& gains);

/// Checks a loop without a motion. @throws InputError as simulate()
/// @{
void require_control(const MotorDesign& design, const MotionTask& task,
                     const SpeedControl& control);
void require_control(const MotorDesign& design, const MotionTask& task,
                     const PositionControl& control);
/// @}

/// Follows a motor whose frequency or voltage is set by a loop; the task's own profile of it is ignored. Gains and margins are those
/// of the steady state at the largest reference, under the load torque that is there at that time.
/// @throws InputError as simulate() without a loop; for a loop that is not admissible; if the speed does not change with the output
///         in one direction on all of its range; and if no output in the range gives the largest reference.
ControlledMotion simulate(const MotorDesign& design, const MotionTask& task,
                          const SpeedControl& control);

/// Follows a motor to angles. A motor that is far from the goal runs at the frequency that gives it the speed kp e without load, as
/// far as friction can still brake it; nearer, where the range has no speed that is low enough, the drive is on for a part of each
/// sample. With the averaged engine a motion ends as `swap-too-early` if off_time is too short for the wave to decay.
/// @throws InputError as for a speed loop; oscillating: without rotor_mass
Motion simulate(const MotorDesign& design, const MotionTask& task, const PositionControl& control);

}  // namespace twum::inline v0_1::motion
