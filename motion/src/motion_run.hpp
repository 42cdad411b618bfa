// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "engine.hpp"
#include "equations.hpp"
#include "watch.hpp"

#include <twum/motion/motion.hpp>

#include <vector>

namespace twum::motion {

/// One motion while it is integrated: stretch after stretch, and within each from event to event.
class MotionRun final : public Engine {
 public:
  MotionRun(const MotorDesign& design, const MotionTask& task);

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
  bool end_early(const std::string& status);
  void take_samples();
  /// Mode of a rotor at rest; the load decides (M4.1).
  Mode mode_at_rest();
  void note(MotionEventKind kind);
  double smallest_scale() const;
  std::vector<double> absolute_tolerances() const;

  const MotorDesign& design_;
  const MotionTask& task_;
  MotionModel model_;
  Equations equations_;
  Integrator integrator_;
  Watch watch_;
  States y_{};
  double time_{0};
  std::size_t next_sample_{0};
  Motion motion_{};
};

}  // namespace twum::motion
