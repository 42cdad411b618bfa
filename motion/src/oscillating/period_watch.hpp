// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model.hpp"

#include <twum/motion/motion.hpp>

#include <vector>

namespace twum::inline v0_1::motion {

/// Finds events in samples of each period: rest, release, reversal, and those of a Watch.
class PeriodWatch {
 public:
  PeriodWatch(const MotionModel& model, bool held) : model_(&model), held_(held) {}

  /// Events up to a sample, with the one before it, a period apart.
  std::vector<MotionEvent> events(const MotionSample& before, const MotionSample& here);

 private:
  void watch_rest(const MotionSample& here, std::vector<MotionEvent>& found);
  void watch_wave(const MotionSample& before, const MotionSample& here,
                  std::vector<MotionEvent>& found);

  const MotionModel* model_;
  bool held_;
  double side_{0};     // sign of the speed since it was last no mere creep
  double largest_{0};  // amplitude since the release
  bool overruns_{false};
};

}  // namespace twum::inline v0_1::motion
