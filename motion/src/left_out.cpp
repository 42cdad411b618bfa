// SPDX-License-Identifier: Apache-2.0
#include <twum/motion/left_out.hpp>

#include "hopping.hpp"
#include "model.hpp"

#include <twum/core/motor.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace twum::motion {
namespace {

constexpr double kGrown = 5;  // e^5 = 150: seen and heard

// Growth of a disturbance along a motion, G' = rate, G >= 0, by trapezoids.
class Growth {
 public:
  explicit Growth(MotionEventKind kind) : kind_(kind) {}

  void add(const MotionSample& sample, double rate) {
    if (std::isnan(rate)) rate = 0;
    if (before_) {
      const double before = grown_;
      grown_ = std::max(0.0, grown_ + 0.5 * (rate + rate_) * (sample.time - *before_));
      if (grown_ > kGrown && before <= kGrown)
        event_ = event_.value_or(
            MotionEvent{kind_, sample.time, sample.speed, sample.angle, sample.amplitude});
    }
    before_ = sample.time, rate_ = rate;
  }
  const std::optional<MotionEvent>& event() const { return event_; }

 private:
  MotionEventKind kind_;
  std::optional<double> before_;
  double rate_{0}, grown_{0};
  std::optional<MotionEvent> event_;
};

// The motor under the wave of a sample.
MotorDesign under_wave(const MotorDesign& given, const MotionSample& sample) {
  MotorDesign design = given;
  design.stator.amplitude = sample.amplitude;
  design.stator.frequency = sample.frequency;
  design.stator.frequency_ratio.reset();
  return design;
}

}  // namespace

void add_what_is_left_out(const MotorDesign& design, const MotionTask& task, Motion& motion) {
  if (!design.rotor.mass || !has_modal_data(design)) return;
  const MotionModel model(design);
  Growth squeal(MotionEventKind::squeals), bounce(MotionEventKind::bounces);
  for (const MotionSample& sample : motion.samples) {
    const bool back = std::ranges::any_of(task.reversed, [&](const Interval& one) {
      return one.begin <= sample.time && sample.time < one.end;
    });
    const double speed = back ? -sample.speed : sample.speed;
    double squeal_rate = NAN, bounce_rate = NAN;
    if (sample.amplitude > 2 * model.full_contact_amplitude && !sample.held) {
      const MotorDesign there = under_wave(model.motor.design(), sample);
      squeal_rate = Motor(there).backward_wave(speed).squeal_rate;
      bounce_rate = hopping_rate(model, there, speed);
    }
    squeal.add(sample, squeal_rate), bounce.add(sample, bounce_rate);
  }
  for (const Growth* one : {&squeal, &bounce})
    if (one->event()) motion.events.push_back(*one->event());
  std::ranges::stable_sort(motion.events, {}, &MotionEvent::time);
}

}  // namespace twum::motion
