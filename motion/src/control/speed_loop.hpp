// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "stretches.hpp"

#include <twum/motion/control.hpp>

#include <deque>

namespace twum::motion {

/// An encoder, or an exact angle.
class AngleSensor {
 public:
  explicit AngleSensor(const std::optional<double>& counts);
  /// The angle in whole counts [rad].
  double read(double angle) const;
  /// Angle of a count [rad]; 0 if the angle is exact.
  double count() const { return count_; }

 private:
  double count_{0};
};

/// The controller of a speed loop, sample by sample.
class SpeedLoop {
 public:
  /// @param angle, speed  at the beginning
  SpeedLoop(const SpeedControl& control, const LoopGains& gains, double angle, double speed);

  /// A measurement of the angle at a time; sets the output that holds until the next.
  void sample(double time, double angle);
  /// What the drive gets now [Hz or V].
  double output() const { return output_; }

 private:
  double limited(double asked) const;

  const SpeedControl* control_;
  LoopGains gains_;
  AngleSensor sensor_;
  double last_angle_;
  double integral_, newest_, output_;
  std::deque<double> waiting_{};  // outputs that the delay holds back
};

}  // namespace twum::motion
