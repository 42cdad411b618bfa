// SPDX-License-Identifier: Apache-2.0
#include "oscillating/oscillating_run.hpp"

#include "steady.hpp"

#include <twum/base/error.hpp>
#include <twum/base/no_value.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace twum::inline v0_1::motion {
namespace {

constexpr double kPointsOfOne = 64, kStepsOfOne = 100;  // at an accuracy of 1
constexpr double kQuarter = std::numbers::pi / 2;

int times_accuracy(double of_one, double accuracy) {
  return static_cast<int>(std::lround(of_one * accuracy));
}

MotorDesign with_equal_phases(MotorDesign design) {
  design.stator.imbalance.reset();
  return design;
}

void require_wave_of_voltage(const MotorDesign& design) {
  if (design.stator.radial_motion)
    throw InputError("radial_motion must be false for a motion in time, but is true");
  if (!design.stator.voltage)
    throw InputError(
        "the oscillating engine needs a motor under a voltage; give stator.voltage and modal data");
}

bool has_one_wave(const MotionTask& task) {
  return std::ranges::all_of(task.phase_difference.rows(),
                             [](const Profile::Row& row) { return row.second == kQuarter; });
}

void require_rotor_mass(const MotorDesign& design, const MotionTask& task) {
  if (design.rotor.mass || (has_one_wave(task) && task.reversed.empty())) return;
  throw InputError(
      "rotor_mass is missing; with a phase difference other than 90 deg, or phases that are "
      "swapped, it decides how both waves share the rotor: give rotor.mass, such as 0.1 kg, or 0 "
      "kg for a rotor that follows the wave");
}

void require_accuracy(double accuracy) {
  for (const double known : {0.5, 1.0, 2.0, 4.0})
    if (accuracy == known) return;
  throw InputError("the accuracy of an oscillating motion must be 1, 2 or 4 (0.5 to compare)");
}

const MotorDesign& checked(const MotorDesign& design, const MotionTask& task) {
  require_wave_of_voltage(design);
  require_rotor_mass(design, task);
  require_accuracy(task.accuracy);
  if (task.initial.steady && !has_one_wave(task))
    throw InputError(
        "a steady beginning needs a phase difference of 90 deg at all times; begin at rest");
  return design;
}

double rms(Complex phasor) { return std::abs(phasor) * std::numbers::sqrt2 / 2; }

}  // namespace

OscillatingRun::OscillatingRun(const MotorDesign& design, const MotionTask& task)
    : design_(checked(design, task)),
      task_(task),
      model_((LayerLaw(design), with_equal_phases(design))),
      waves_(design, model_, times_accuracy(kPointsOfOne, task.accuracy)),
      watch_(model_, task.initial.speed == 0 && !task.initial.steady),
      imbalance_(design.stator.imbalance.value_or(Imbalance{})),
      steps_(times_accuracy(kStepsOfOne, task.accuracy)) {
  const double longest = waves_.longest_step() * task.frequency.largest();
  if (steps_ * longest < 1)
    throw InputError(
        "the contact is too stiff for the steps of the oscillating engine: rotor_inertia, "
        "rotor_mass or modal_mass vibrates on it within a step; use the averaged engine");
}

void OscillatingRun::begin(const Stretch& first) {
  stretch_ = first;
  double speed = task_.initial.speed;
  Complex voltage = 0, current = 0;  // of the terminals behind a series branch
  Complex zeta = std::polar(task_.initial.amplitude, -task_.initial.phase_lag);
  if (task_.initial.steady) {
    const MotorDesign equal = with_equal_phases(design_);
    Equations equations(model_);
    equations.set_stretch(first);
    const States y = steady_state(equal, equations);
    speed = y[kSpeed], zeta = {y[kReal], y[kImaginary]};
    const auto terminals = equations.electrical(first.begin, y);
    voltage = terminals.voltage, current = terminals.current;
  }
  if (speed != 0 || zeta != Complex{}) lead_in(first, zeta, speed);
  WavesState state = waves_.state();
  state.angle = task_.initial.angle, state.rise = 0;
  state.voltage = acting_at(0).voltage;
  if (model_.has_series()) {
    state.voltage = {voltage.real(), first.direction * voltage.imag()};
    state.current = {current.real(), first.direction * current.imag()};
  }
  waves_.set_state(state);
  waves_.take_work();
  later_ = first_sample(speed, zeta);
  take_speed(motion_, speed);
  open_period();
}

MotionSample OscillatingRun::first_sample(double speed, Complex zeta) const {
  MotionSample sample{.speed = speed, .angle = task_.initial.angle};
  sample.held = speed == 0 && zeta == Complex{};
  sample.torque = waves_.torque();
  const Complex first = std::numbers::sqrt2 * stretch_.voltage.value;
  BothWays wave{zeta, 0};
  if (stretch_.direction < 0) std::swap(wave.forward, wave.backward);
  add_phasors(sample, wave, {first, 0});
  return sample;
}

// Over four turns, so that the layer has its periodic state. The wave may be anywhere at the beginning: the drive has the phase 0.
void OscillatingRun::lead_in(const Stretch& first, Complex zeta, double speed) {
  constexpr int kTurns = 4;
  const double rate = 2 * std::numbers::pi * first.frequency.value;
  const double step = 1 / (first.frequency.value * steps_);
  const auto wave = [&](int k) {
    const Complex now = zeta * std::polar(1.0, rate * step * k);
    return Two{now.real(), first.direction * now.imag()};
  };
  const int count = kTurns * steps_;
  WavesState state = waves_.state();
  state.angle = -count * step * speed;
  state.displacement = wave(-count);
  waves_.set_state(state);
  for (int k = 1 - count; k <= 0; ++k) waves_.lead(wave(k), speed, step);
  state = waves_.state();
  const Complex velocity = kI * rate * zeta;
  state.velocity = {velocity.real(), first.direction * velocity.imag()};
  waves_.set_state(state);
}

ActingNow OscillatingRun::acting_at(double time) const {
  const double now = std::min(time, stretch_.end);
  const double peak = std::numbers::sqrt2 * stretch_.voltage.at(now);
  const double lag = stretch_.phase_difference.at(now) - imbalance_.phase_error;
  const double second = stretch_.direction * imbalance_.voltage_ratio * std::cos(phase_ - lag);
  return {{peak * std::cos(phase_), peak * second}, stretch_.off, stretch_.load_torque.at(now)};
}

void OscillatingRun::enter(const Stretch& stretch) {
  const auto note = [&](MotionEventKind kind) {
    const WavesState& s = waves_.state();
    motion_.events.push_back({kind, stretch.begin, s.speed, s.angle, later_.amplitude});
  };
  if (stretch.off != stretch_.off)
    note(stretch.off ? MotionEventKind::switched_off : MotionEventKind::switched_on);
  if (stretch.direction != stretch_.direction) note(MotionEventKind::swapped);
  stretch_ = stretch;
}

void OscillatingRun::open_period() {
  period_ = Period(time_, waves_.state(), energy_);
  done_ = 0;
  step_ = 1 / (stretch_.frequency.at(std::min(time_, stretch_.end)) * steps_);
  waves_.set_step(step_);
}

bool OscillatingRun::follow(const Stretch& stretch) {
  enter(stretch);
  while (time_ < stretch.end - step_ / 2) {
    step();
    if (done_ < steps_) continue;
    if (task_.go_on && !task_.go_on(time_)) {
      motion_.status = "stopped";
      return false;
    }
    if (!std::isfinite(waves_.state().speed) || !std::isfinite(later_.amplitude)) {
      motion_.status = "integrator-failed";
      return false;
    }
    open_period();
  }
  return true;
}

void OscillatingRun::step() {
  const ActingNow before = acting_at(time_);
  const double middle = std::min(time_ + step_ / 2, stretch_.end);
  const double frequency = stretch_.frequency.at(middle);
  phase_ += 2 * std::numbers::pi * frequency * step_;
  time_ += step_;
  waves_.step(before, acting_at(time_));
  period_.add(waves_.state(), phase_, 2 * std::numbers::pi * frequency);
  ++motion_.steps, ++done_;
  if (done_ == steps_) close_period();
}

void OscillatingRun::close_period() {
  const WavesWork work = waves_.take_work();
  MotionSample sample = period_.sample(time_, waves_.state(), work);
  add_phasors(sample, period_.displacement(), period_.voltage());
  energy_ += work.drive;
  earlier_ = later_, later_ = sample;
  take_speed(motion_, sample.speed);
  for (const MotionEvent& event : watch_.events(earlier_, later_)) motion_.events.push_back(event);
  take_samples();
}

void OscillatingRun::add_phasors(MotionSample& s, const BothWays& displacement,
                                 const BothWays& voltage) const {
  const double now = std::clamp(s.time, stretch_.begin, stretch_.end);
  s.frequency = stretch_.frequency.at(now), s.load_torque = stretch_.load_torque.at(now);
  s.phase_difference = stretch_.phase_difference.at(now), s.off = stretch_.off;
  s.amplitude = std::abs(displacement.forward), s.phase_lag = -std::arg(displacement.forward);
  s.backward_amplitude = std::abs(displacement.backward);
  s.voltage = rms(voltage.phasor(0));
  const double omega = 2 * std::numbers::pi * s.frequency;
  const Complex admittance = kI * omega * model_.capacitance * Complex{1, -model_.loss_tangent};
  const auto current = [&](int phase) {  // (D4.1)
    return rms(admittance * voltage.phasor(phase) +
               kI * omega * model_.force_factor * displacement.phasor(phase));
  };
  s.phase_current = std::max(current(0), current(1));
}

void OscillatingRun::take_samples() {
  const std::vector<double>& times = task_.output_times;
  while (next_sample_ < times.size() && times[next_sample_] <= later_.time)
    motion_.samples.push_back(between(earlier_, later_, times[next_sample_++]));
}

// The rotor turns on evenly from the last step.
double OscillatingRun::angle() const {
  const WavesState& state = waves_.state();
  return state.angle + state.speed * (stretch_.end - time_);
}

// The last samples need the periods behind them, with the drive going on.
Motion OscillatingRun::finish() {
  const bool complete = motion_.status == "ok";
  motion_.end = complete ? stretch_.end : later_.time;
  const std::vector<MotionEvent> events = motion_.events;
  const long steps = motion_.steps;
  while (complete && later_.time < motion_.end) {
    if (done_ == steps_) open_period();
    step();
  }
  motion_.last = between(earlier_, later_, motion_.end);
  std::erase_if(motion_.samples, [&](const MotionSample& s) { return s.time > motion_.end; });
  motion_.events = events, motion_.steps = steps;
  return std::move(motion_);
}

}  // namespace twum::inline v0_1::motion
