// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "control/loop.hpp"

#include <twum/motion/control.hpp>

#include <deque>
#include <functional>

namespace twum::inline v0_1::motion {

/// A controller of the angle: as fast as the rest of the way allows, in bursts near the goal, and off at the goal.
class PositionLoop final : public Loop {
 public:
  /// @param output        frequency that gives a speed without load [Hz]
  /// @param slowest       speed at the upper end of the range [rad/s]
  /// @param deceleration  of friction alone, alpha [rad/s^2]
  PositionLoop(const PositionControl& control, std::function<double(double)> output, double slowest,
               double deceleration);

  void begin(double angle, double speed) override;
  void sample(double time, double angle) override;
  std::vector<Stretch> applied(const Stretch& stretch) const override;

 private:
  // What the drive does in a sample.
  struct Drive {
    double frequency, share, direction;  // on for a share of the sample, from its beginning
  };
  Drive asked(double time, double error, double speed);
  Drive driven(double speed);
  Drive off() const { return {newest_.frequency, 0, newest_.direction}; }

  const PositionControl& control_;
  std::function<double(double)> output_;
  double slowest_, deceleration_;
  AngleSensor sensor_;
  double last_angle_{0};
  double waits_until_{0};  // with the drive off, before the phases are swapped
  double next_direction_{1};
  double saved_share_{0};  // of bursts too short to be given
  Drive newest_, now_;
  double now_begin_{0};
  std::deque<Drive> waiting_;
};

}  // namespace twum::inline v0_1::motion
