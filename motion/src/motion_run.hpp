// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "engine.hpp"
#include "equations.hpp"
#include "watch.hpp"

#include <twum/motion/motion.hpp>

#include <functional>
#include <span>
#include <vector>

namespace twum::inline v0_1::motion {

/// What a metric asks of a motion beside its end.
struct RunWatch {
  /// Called after each step with the integrator and the time at which the step began; true ends the motion there. May be empty.
  std::function<bool(const Integrator&, double)> reached{};
  /// Ends the motion where the rotor is held with the drive off.
  bool until_held{false};
  /// Columns of dy/dq to be integrated beside y; null for none.
  const ModelSlopes* slopes{nullptr};
  /// Derivative of the time at which the second stretch begins in each column; empty if it stays.
  std::vector<double> switch_slopes{};
};

/// Where a motion ended, with derivatives.
struct RunEnd {
  States y{};
  double time{0};                     ///< [s]
  bool held{false};                   ///< friction holds the rotor
  std::vector<double> slopes{};       ///< dy/dq there, at a time that moves as
  std::vector<double> time_slopes{};  ///< dt/dq of an end at rest; else empty
};

/// One motion while it is integrated: stretch after stretch, and within each from event to event.
class MotionRun final : public Engine {
 public:
  MotionRun(const MotorDesign& design, const MotionTask& task, RunWatch watch = {});
  /// After finish(): where it ended.
  RunEnd end() const { return {y_, time_, equations_.mode().held, slopes_, time_slopes_}; }

  void begin(const Stretch& first) override;
  bool follow(const Stretch& stretch) override;
  double angle() const override { return y_[kAngle]; }
  double speed() const override { return y_[kSpeed]; }
  Motion finish() override;

 private:
  /// Each is false where the motion ends early.
  /// @{
  bool enter(const Stretch& stretch);
  bool integrate(const Stretch& stretch);
  bool swap_phases();
  /// @}
  void turn_wave();
  void change_mode();
  void cross_event();
  States rates_now();
  void jump(const States& before, const States& after, std::span<const double> time_slopes);
  void read_slopes();
  bool end_early(const std::string& status);
  void take_samples();
  void take_speeds(double begin);
  /// The circuit of a driver with a series branch that is switched on at a wave of the motor.
  void open_circuit(Complex voltage);
  std::size_t count() const { return equations_.places().count; }
  /// Mode of a rotor at rest; the load decides (M4.1).
  Mode mode_at_rest();
  void note(MotionEventKind kind);
  double smallest_scale() const;
  std::vector<double> absolute_tolerances() const;

  const MotorDesign& design_;
  const MotionTask& task_;
  RunWatch asked_;
  MotionModel model_;
  Equations equations_;
  Integrator integrator_;
  Watch watch_;
  States y_{};
  std::vector<double> slopes_, time_slopes_;
  double time_{0};
  std::size_t next_sample_{0};
  Motion motion_{};
};

}  // namespace twum::inline v0_1::motion
