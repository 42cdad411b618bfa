// SPDX-License-Identifier: Apache-2.0
#include "control/position_loop.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace twum::inline v0_1::motion {
namespace {

constexpr double kShortestBurst = 0.05;  // of a sample

}  // namespace

PositionLoop::PositionLoop(const PositionControl& control, std::function<double(double)> output,
                           double slowest, double deceleration)
    : control_(control),
      output_(std::move(output)),
      slowest_(slowest),
      deceleration_(deceleration),
      sensor_(control.encoder),
      newest_{control.range.second, 0, 1},
      now_(newest_),
      waiting_(static_cast<std::size_t>(control.delay), newest_) {}

void PositionLoop::begin(double angle, double speed) {
  last_angle_ = sensor_.read(angle - speed * control_.sample_time);
}

void PositionLoop::sample(double time, double angle) {
  const double here = sensor_.read(angle), sample = control_.sample_time;
  const double speed = (here - last_angle_) / sample;
  last_angle_ = here;
  const double expected = here + speed * sample * control_.delay;  // when the output takes hold
  newest_ = asked(time, control_.reference.after(time) - expected, speed);
  waiting_.push_back(newest_);
  now_ = waiting_.front(), now_begin_ = time;
  waiting_.pop_front();
}

PositionLoop::Drive PositionLoop::asked(double time, double error, double speed) {
  const double count = sensor_.count();
  const bool slow = std::abs(speed) * control_.sample_time < 1.5 * count;  // a count at most
  if (std::abs(error) <= control_.window * count && slow) {
    saved_share_ = 0;
    return off();
  }
  // w = kp e, and no more than it can brake, sqrt(2 beta alpha |e|)  (M8.2)
  const double most = std::sqrt(2 * control_.braking * deceleration_ * std::abs(error));
  const double wanted = std::clamp(*control_.gain * error, -most, most);
  const double direction = wanted < 0 ? -1 : 1;
  if (direction != next_direction_) {
    next_direction_ = direction, saved_share_ = 0;
    waits_until_ = time + control_.off_time;
  }
  if (time < waits_until_ - 1e-3 * control_.sample_time) return off();
  newest_.direction = next_direction_;
  return driven(std::abs(wanted));
}

PositionLoop::Drive PositionLoop::driven(double speed) {
  const double highest = control_.range.second;
  if (speed < slowest_) {
    saved_share_ += speed / slowest_;
    const double share = saved_share_ < kShortestBurst ? 0 : std::min(saved_share_, 1.0);
    if (share > 0) saved_share_ = 0;
    return {highest, share, newest_.direction};
  }
  saved_share_ = 0;
  double frequency = output_(speed);
  const double from = newest_.share > 0 ? newest_.frequency : highest;
  if (control_.slew) frequency = std::max(frequency, from - *control_.slew * control_.sample_time);
  return {frequency, 1, newest_.direction};
}

std::vector<Stretch> PositionLoop::applied(const Stretch& stretch) const {
  Stretch on = stretch, rest = stretch;
  on.frequency = rest.frequency = Ramp{stretch.begin, now_.frequency, 0};
  on.direction = rest.direction = now_.direction;
  rest.off = true;
  const double end = now_begin_ + now_.share * control_.sample_time;
  const double least = 1e-6 * control_.sample_time;
  if (end <= stretch.begin + least) return {rest};
  if (end >= stretch.end - least) return {on};
  on.end = rest.begin = end;
  return {on, rest};
}

}  // namespace twum::inline v0_1::motion
