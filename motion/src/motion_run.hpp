// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "equations.hpp"
#include "watch.hpp"

#include <twum/motion/motion.hpp>

#include <vector>

namespace twum::motion {

/// One motion while it is integrated: stretch after stretch, and within each from event to event.
class MotionRun {
 public:
  MotionRun(const MotorDesign& design, const MotionTask& task);
  Motion run();

  /// The state at the beginning.
  void begin();

 private:
  Stretch before_the_first() const;
  /// Each is false where the motion ends early.
  /// @{
  bool enter(const Stretch& stretch);
  bool follow(const Stretch& stretch);
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
  std::vector<Stretch> stretches_;
  Equations equations_;
  Integrator integrator_;
  Watch watch_;
  Stretch before_{};
  States y_{};
  double time_{0};
  std::size_t next_sample_{0};
  Motion motion_{};
};

}  // namespace twum::motion
