// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "control/loop.hpp"

#include <twum/motion/control.hpp>

#include <deque>

namespace twum::inline v0_1::motion {

/// A PI controller of the speed.
class SpeedLoop final : public Loop {
 public:
  SpeedLoop(const SpeedControl& control, const LoopGains& gains);

  void begin(double angle, double speed) override;
  void sample(double time, double angle) override;
  std::vector<Stretch> applied(const Stretch& stretch) const override;

 private:
  double limited(double asked) const;

  const SpeedControl& control_;
  LoopGains gains_;
  AngleSensor sensor_;
  double last_angle_{0};
  double integral_, newest_, output_;
  std::deque<double> waiting_;  // outputs that the delay holds back
};

}  // namespace twum::inline v0_1::motion
