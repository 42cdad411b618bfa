// SPDX-License-Identifier: Apache-2.0
#include "control/speed_loop.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace twum::motion {

AngleSensor::AngleSensor(const std::optional<double>& counts) {
  if (counts) count_ = 2 * std::numbers::pi / *counts;
}

double AngleSensor::read(double angle) const {
  return count_ > 0 ? count_ * std::floor(angle / count_) : angle;
}

SpeedLoop::SpeedLoop(const SpeedControl& control, const LoopGains& gains, double angle, double speed)
    : control_(&control),
      gains_(gains),
      sensor_(control.encoder),
      last_angle_(sensor_.read(angle - speed * control.sample_time)),
      integral_(control.start),
      newest_(control.start),
      output_(control.start),
      waiting_(static_cast<std::size_t>(control.delay), control.start) {}

double SpeedLoop::limited(double asked) const {
  auto [least, most] = control_->range;
  if (control_->slew) {
    const double step = *control_->slew * control_->sample_time;
    least = std::max(least, newest_ - step), most = std::min(most, newest_ + step);
  }
  return std::clamp(asked, least, most);
}

void SpeedLoop::sample(double time, double angle) {
  const double here = sensor_.read(angle);
  const double speed = (here - last_angle_) / control_->sample_time;
  last_angle_ = here;
  const double error = control_->reference.after(time) - speed;
  const double more = gains_.integral * control_->sample_time * error;
  const double asked = integral_ + gains_.proportional * error + more;
  newest_ = limited(asked);
  if (newest_ == asked) integral_ += more;  // it waits while the output is at a limit
  waiting_.push_back(newest_);
  output_ = waiting_.front();
  waiting_.pop_front();
}

}  // namespace twum::motion
