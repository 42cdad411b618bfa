// SPDX-License-Identifier: Apache-2.0
#include <twum/motion/left_out.hpp>

#include "hopping.hpp"
#include "model.hpp"
#include "poles.hpp"
#include "slow_flow.hpp"

#include <twum/core/contact_slopes.hpp>
#include <twum/core/motor.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace twum::inline v0_1::motion {
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

// Of the wave's rate: at a smaller rate the motion takes 30 rad of the wave's phase or more, about five turns.
constexpr double kSlow = 1.0 / 30;
constexpr std::size_t kLooks = 100;  // samples that are checked

// Of the rotor in the direction of the wave.
double speed_along_wave(const MotionTask& task, const MotionSample& sample) {
  const bool back = std::ranges::any_of(task.reversed, [&](const Interval& one) {
    return one.begin <= sample.time && sample.time < one.end;
  });
  return back ? -sample.speed : sample.speed;
}

// The wave is one that drives, and the contact not full.
bool is_running(const MotionModel& model, const MotionSample& sample) {
  return sample.amplitude > 2 * model.full_contact_amplitude && !sample.held;
}

// Near a steady state of the drive, of which (M7.1) tells.
bool is_settled(const MotionModel& model, const MotionSample& sample) {
  constexpr double kShare = 0.1;  // of the holding torque, which accelerates the rotor
  const double accelerates = sample.torque - sample.load_torque - model.spring(sample.angle) -
                             model.load_damping * sample.speed;
  return !sample.off && is_running(model, sample) &&
         std::abs(accelerates) < kShare * model.holding_torque + model.load_friction;
}

// The smallest root of (M7.1) over W = omega + n Omega, the rate of the wave over the rotor; 0 where the contact has no answer.
double slowness(const MotionModel& model, const MotionSample& sample, double speed) {
  const ContactSlopes contact =
      contact_slopes(model.motor, {speed, sample.amplitude, sample.frequency});
  if (contact.status != PointStatus::ok) return 0;
  const auto slopes = [](const ContactSlopes::Number& n) {
    return ForceSlopes{n.value, n.per_amplitude, n.per_speed};
  };
  const double omega = 2 * std::numbers::pi * sample.frequency;
  const SlowFlow flow = slow_flow(model, sample.amplitude, omega, slopes(contact.reactive_force),
                                  slopes(contact.active_force), slopes(contact.torque));
  const Eigen::Vector3d unit{sample.amplitude, 1,
                             model.crest_per_amplitude * omega * sample.amplitude};
  const double slowest = std::abs(nearest_pole(poles_of(flow.jacobian, unit), 0));
  return slowest / (omega + model.motor.design().stator.wavelengths * speed);
}

// Where the motion is first too fast.
std::optional<MotionEvent> first_too_fast(const MotionModel& model, const MotionTask& task,
                                          const Motion& motion) {
  const std::size_t step = 1 + motion.samples.size() / kLooks;
  for (std::size_t k = 0; k < motion.samples.size(); k += step) {
    const MotionSample& s = motion.samples[k];
    if (is_settled(model, s) && slowness(model, s, speed_along_wave(task, s)) > kSlow)
      return MotionEvent{MotionEventKind::too_fast, s.time, s.speed, s.angle, s.amplitude};
  }
  return {};
}

}  // namespace

void add_what_is_left_out(const MotorDesign& design, const MotionTask& task, Motion& motion) {
  if (!has_modal_data(design)) return;
  const MotionModel model(design);
  if (design.stator.voltage)
    if (const auto event = first_too_fast(model, task, motion)) motion.events.push_back(*event);
  Growth squeal(MotionEventKind::squeals), bounce(MotionEventKind::bounces);
  for (const MotionSample& sample : motion.samples) {
    if (!design.rotor.mass || (task.go_on && !task.go_on(sample.time))) break;
    const double speed = speed_along_wave(task, sample);
    double squeal_rate = NAN, bounce_rate = NAN;
    if (is_running(model, sample)) {
      const MotorDesign there = under_wave(model.motor.design(), sample);
      squeal_rate = Motor(there).backward_wave(speed).squeal_rate;
      if (task.axial == AxialMotion::balanced) bounce_rate = hopping_rate(model, there, speed);
    }
    squeal.add(sample, squeal_rate), bounce.add(sample, bounce_rate);
  }
  for (const Growth* one : {&squeal, &bounce})
    if (one->event()) motion.events.push_back(*one->event());
  std::ranges::stable_sort(motion.events, {}, &MotionEvent::time);
}

}  // namespace twum::inline v0_1::motion
