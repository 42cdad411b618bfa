// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "motion_run.hpp"

#include <optional>
#include <vector>

namespace twum::inline v0_1::motion {

/// A number with its derivatives in the columns of ModelSlopes; without them only the number.
struct Moving {
  double value{0};
  std::vector<double> slopes{};
};

/// A state on the way, at a time within a step.
struct Place {
  double time;
  std::vector<double> y, rates, slopes;
};

/// The steady state under a load.
struct Steady {
  States y;
  std::vector<double> slopes;
  Complex zeta() const { return {y[kReal], y[kImaginary]}; }
};

/// What a start tells.
struct Start {
  Steady steady;
  std::optional<Place> reached{};  ///< 90 % of the steady speed
  std::optional<Place> fastest{};  ///< the highest peak of the speed
};

/// Runs the standard manoeuvres of one design, under its drive (theory of motion, section 7). All throw WithoutValue where there is no
/// such manoeuvre, and InputError as simulate().
class ManoeuvreRuns {
 public:
  /// @param slopes  null for values alone
  ManoeuvreRuns(const MotorDesign& design, const ModelSlopes* slopes)
      : design_(design), model_(design), slopes_(slopes) {}

  /// From rest until the speed has settled.
  Start start(double torque) const { return started(torque, Until::settled); }
  Moving start_time(const Start& start) const;
  Moving start_overshoot(const Start& start) const;
  /// True if a step of the drive starts the motor without load.
  bool starts() const;

  /// From the steady state until friction holds the rotor.
  RunEnd stop(double torque) const;
  Moving stop_time(const RunEnd& end) const;
  Moving stop_angle(const RunEnd& end) const;

  Moving burst_angle(double periods) const;
  Moving move_energy(double angle) const;

 private:
  enum class Until : unsigned char { reached, settled };

  /// Of states, which is also the distance of the slopes of two parameters.
  std::size_t count() const { return StatePlaces(model_, AxialMotion::balanced).count; }

  Steady steady(double torque) const;
  Start started(double torque, Until until) const;
  RunEnd burst(double on, std::vector<double> switch_slopes = {}) const;
  double time_to(double angle) const;
  double own_time() const;
  MotionTask task_of(double duration, double torque) const;
  RunEnd held_end(const MotionTask& task, RunWatch watch) const;
  void run(MotionRun& run, const MotionTask& task) const;
  template <typename Slope>
  Moving moving(double value, Slope slope) const;

  const MotorDesign& design_;
  MotionModel model_;
  const ModelSlopes* slopes_;
};

}  // namespace twum::inline v0_1::motion
