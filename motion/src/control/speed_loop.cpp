// SPDX-License-Identifier: Apache-2.0
#include "control/speed_loop.hpp"

#include <algorithm>

namespace twum::inline v0_1::motion {

SpeedLoop::SpeedLoop(const SpeedControl& control, const LoopGains& gains)
    : control_(control),
      gains_(gains),
      sensor_(control.encoder),
      integral_(control.start),
      newest_(control.start),
      output_(control.start),
      waiting_(static_cast<std::size_t>(control.delay), control.start) {}

void SpeedLoop::begin(double angle, double speed) {
  last_angle_ = sensor_.read(angle - speed * control_.sample_time);
}

double SpeedLoop::limited(double asked) const {
  auto [least, most] = control_.range;
  if (control_.slew) {
    const double step = *control_.slew * control_.sample_time;
    least = std::max(least, newest_ - step), most = std::min(most, newest_ + step);
  }
  return std::clamp(asked, least, most);
}

// u = I + kp e + ki T_s e, and I grows by ki T_s e unless u is at a limit.
void SpeedLoop::sample(double time, double angle) {
  const double here = sensor_.read(angle);
  const double speed = (here - last_angle_) / control_.sample_time;
  last_angle_ = here;
  const double error = control_.reference.after(time) - speed;
  const double more = gains_.integral * control_.sample_time * error;
  const double asked = integral_ + gains_.proportional * error + more;
  newest_ = limited(asked);
  if (newest_ == asked) integral_ += more;
  waiting_.push_back(newest_);
  output_ = waiting_.front();
  waiting_.pop_front();
}

std::vector<Stretch> SpeedLoop::applied(const Stretch& stretch) const {
  Stretch now = stretch;
  (control_.actuator == Actuator::voltage ? now.voltage : now.frequency) =
      Ramp{stretch.begin, output_, 0};
  return {now};
}

}  // namespace twum::inline v0_1::motion
