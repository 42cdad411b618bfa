// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motor_design.hpp>
#include <twum/motion/linear_plant.hpp>
#include <twum/motion/motion.hpp>

#include <complex>
#include <optional>
#include <utility>
#include <vector>

namespace twum::motion {

/// What a loop changes at the drive.
enum class Actuator : unsigned char { frequency, voltage };

/// Gains of a PI controller of the speed. Its output is a frequency [Hz] or a voltage, rms [V].
struct LoopGains {
  double proportional;  ///< kp [unit of the output s/rad]
  double integral;      ///< ki [unit of the output/rad]
};

/// A sampled loop of the speed, by the angle of an encoder.
struct SpeedControl {
  Profile reference{};                 ///< Omega_ref [rad/s], 0 or more
  double sample_time{1e-3};            ///< T_s [s]
  int delay{1};                        ///< whole samples from a measurement to its output
  std::optional<double> encoder{};     ///< counts a turn; without it the angle is exact
  Actuator actuator{Actuator::frequency};  ///< what the loop changes
  std::pair<double, double> range{};   ///< of the output [Hz or V]
  double start{0};                     ///< the output at the beginning, within the range [Hz or V]
  std::optional<double> slew{};        ///< largest change of the output over time [Hz/s or V/s]
  std::optional<LoopGains> gains{};    ///< without them those of (M8.1)
};

/// The motor as a loop of its speed sees it at one operating point.
struct LoopPlant {
  double output{0};         ///< of the loop: frequency [Hz] or voltage, rms [V]
  double speed{0};          ///< Omega [rad/s]
  double gain{0};           ///< K, steady change of the speed over that of the output [rad/s/Hz or rad/s/V]
  double time_constant{0};  ///< tau, 1 / |Re p| of the slowest pole p [s]
  std::vector<std::complex<double>> poles{};  ///< the slowest first [1/s]
};

/// How far a loop is from instability. Infinite where nothing makes it unstable.
struct LoopMargins {
  double gain{0};       ///< factor of the gain at which it becomes unstable [1]
  double phase{0};      ///< lag at the crossover at which it becomes unstable [rad]
  double crossover{0};  ///< frequency at which the loop's gain falls through 1 [Hz]; 0 if it never is above
};

/// A motion under control, and what was known of the loop.
struct ControlledMotion {
  Motion motion{};
  LoopGains gains{};      ///< those in use
  LoopPlant plant{};      ///< where gains and margins were computed
  LoopMargins margins{};  ///< of the linear plant there
};

/// K and tau of a linear plant.
LoopPlant loop_plant(const LinearPlant& plant, Actuator actuator);

/// (M8.1) with lambda = 2 theta_d, theta_d = (delay + 1) T_s.
LoopGains loop_gains(const LoopPlant& plant, double sample_time, int delay);

/// Margins of a sampled loop: the linear plant with a held input is discretised exactly.
LoopMargins loop_margins(const LinearPlant& plant, const SpeedControl& control, const LoopGains& gains);

/// Checks a loop without a motion. @throws InputError as simulate()
void require_control(const MotorDesign& design, const MotionTask& task, const SpeedControl& control);

/// Follows a motor whose frequency or voltage is set by a loop; the task's own profile of it is ignored. Gains and margins are those
/// of the steady state at the largest reference, under the load torque that is there at that time.
/// @throws InputError as simulate() without a loop; for a loop that is not admissible; if the speed does not change with the output
///         in one direction on all of its range; and if no output in the range gives the largest reference.
ControlledMotion simulate(const MotorDesign& design, const MotionTask& task,
                          const SpeedControl& control);

}  // namespace twum::motion
