// SPDX-License-Identifier: Apache-2.0
#include "motion_run.hpp"

#include <twum/base/error.hpp>

#include "sample.hpp"
#include "steady.hpp"
#include "zero_in_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

namespace twum::inline v0_1::motion {
namespace {

constexpr double kReleaseSpeed = 1e-9;  // [rad/s]: past the event, and nothing beside any speed
// Of the holding torque. Without it a rotor would be caught at the instant of its release.
constexpr double kHoldMargin = 1e-6;
// Of the largest voltage: below this share a voltage at the terminals counts for nothing.
constexpr double kSmallestVoltage = 1e-2;

void require_axial_motion(const MotionModel& model) {
  if (!(model.rotor_mass > 0))
    throw InputError(
        "rotor_mass is missing; an axial motion of the rotor needs it: give rotor.mass, such as "
        "0.1 "
        "kg, or leave out 'axial: dynamic'");
  if (model.motor.design().stator.radial_slices != 1)
    throw InputError(
        "radial_slices must be 1 for 'axial: dynamic', which has one contact radius, but is " +
        std::to_string(std::abs(model.motor.design().stator.radial_slices)));
}

}  // namespace

MotionRun::MotionRun(const MotorDesign& design, const MotionTask& task, RunWatch watch)
    : design_(design),
      task_(task),
      asked_(std::move(watch)),
      model_(design),
      equations_(model_, asked_.slopes, task.axial),
      integrator_(equations_, 2, task.tolerance, absolute_tolerances(),
                  asked_.slopes ? asked_.slopes->columns().size() : 0),
      watch_(equations_) {
  if (task.axial == AxialMotion::dynamic) require_axial_motion(model_);
  for (const auto& [time, value] : task.phase_difference.rows())
    if (value != std::numbers::pi / 2)
      throw InputError(
          "the averaged engine has one wave, of phases 90 deg apart; use the oscillating engine "
          "for another phase difference");
}

// A tenth of the amplitude at which the contact opens, or without contact a thousandth of the free wave at resonance.
double MotionRun::smallest_scale() const {
  if (model_.full_contact_amplitude > 0) return 0.3 * model_.full_contact_amplitude;
  if (!model_.driven) return 1e-9;
  return 1e-3 * model_.drive_force(std::max(task_.voltage.largest(), 1.0)) /
         (model_.damping * 2 * std::numbers::pi * task_.frequency.largest());
}

std::vector<double> MotionRun::absolute_tolerances() const {
  const double a = task_.tolerance * smallest_scale();
  const double omega = 2 * std::numbers::pi * task_.frequency.largest();
  const StatePlaces& places = equations_.places();
  std::vector<double> absolute(count());
  absolute[kReal] = absolute[kImaginary] = a;
  absolute[kSpeed] = model_.crest_per_amplitude * omega * a;
  absolute[kAngle] = absolute[kTurn] = task_.tolerance * 1e-4;
  // A wave of the smallest scale that is built up.
  absolute[kEnergy] = std::max(task_.tolerance * 1e-5, model_.mass * omega * omega * a * a);
  const auto put = [&](std::size_t pair, double first, double second) {
    if (pair != StatePlaces::kNone) absolute[pair] = first, absolute[pair + 1] = second;
  };
  const double volts = task_.tolerance * kSmallestVoltage * std::max(task_.voltage.largest(), 1.0);
  const double amperes = volts * omega * model_.capacitance;
  put(places.voltage, volts, volts), put(places.current, amperes, amperes);
  put(places.height, a, omega * a);
  return absolute;
}

void MotionRun::note(MotionEventKind kind) {
  motion_.events.push_back({kind, time_, y_[kSpeed], y_[kAngle], equations_.amplitude(time_, y_)});
}

bool MotionRun::end_early(const std::string& status) {
  motion_.status = status;
  return false;
}

Mode MotionRun::mode_at_rest() {
  const HoldingLimits limits = equations_.holding_limits(time_, y_);
  const double load = equations_.load(time_, y_[kAngle]), friction = model_.load_friction;
  const double above = limits.forward - friction - load,  // > 0: the wave turns the rotor forward
      below = load - limits.backward - friction;          // > 0: the load turns it backward
  const double margin = kHoldMargin * model_.holding_torque;
  const bool held = above < -margin && below < -margin;
  return {held, above >= below ? 1.0 : -1.0};
}

void MotionRun::begin(const Stretch& first) {
  const std::size_t columns = asked_.slopes ? asked_.slopes->columns().size() : 0;
  slopes_.assign(columns * count(), 0.0);
  const InitialState& initial = task_.initial;
  equations_.set_stretch(first);
  if (initial.steady) {
    y_ = steady_state(design_, equations_);
    if (columns > 0) slopes_ = steady_slopes(equations_, y_, columns);
    y_[kAngle] = initial.angle;
    return;
  }
  const Complex zeta = std::polar(model_.driven ? initial.amplitude : 0, -initial.phase_lag);
  y_ = {zeta.real(), zeta.imag(), initial.speed, initial.angle};
  if (const std::size_t height = equations_.places().height; height != StatePlaces::kNone)
    y_[height] = model_.balanced_height(equations_.amplitude(0, y_));
  // enter() releases a rotor that nothing holds.
  equations_.set_mode({initial.speed == 0, initial.speed < 0 ? -1.0 : 1.0});
}

bool MotionRun::swap_phases() {
  if (model_.driven && equations_.amplitude(time_, y_) >= 2 * model_.full_contact_amplitude)
    return end_early("swap-too-early");
  y_[kReal] = y_[kImaginary] = 0;  // the other wave begins from rest
  equations_.set_circuit(y_, 0, 0);
  return true;
}

// Up to here the phases lay on R_off, and the coil carried no current.
void MotionRun::open_circuit(Complex voltage) { equations_.set_circuit(y_, voltage, 0); }

// The drive's phase goes on while it is off.
void MotionRun::turn_wave() {
  const Complex zeta = Complex{y_[kReal], y_[kImaginary]} * std::polar(1.0, y_[kTurn]);
  y_[kReal] = zeta.real(), y_[kImaginary] = zeta.imag(), y_[kTurn] = 0;
}

bool MotionRun::enter(const Stretch& stretch) {
  const Stretch before = equations_.stretch();
  const bool swapped = before.direction != stretch.direction, switched = before.off != stretch.off;
  if (swapped && !swap_phases()) return false;
  const bool moves = !asked_.switch_slopes.empty() && stretch.begin > 0;
  const States rates_before = moves ? rates_now() : States{};
  const Complex across = equations_.electrical(stretch.begin, y_).voltage;
  const double turned = y_[kTurn];
  equations_.set_stretch(stretch);
  if (switched) turn_wave();
  if (switched && !stretch.off) open_circuit(across * std::polar(1.0, turned));
  if (switched) note(stretch.off ? MotionEventKind::switched_off : MotionEventKind::switched_on);
  if (swapped) note(MotionEventKind::swapped);
  if (equations_.mode().held) change_mode();
  if (moves) jump(rates_before, rates_now(), asked_.switch_slopes);
  return true;
}

States MotionRun::rates_now() {
  States rates{};
  if (!equations_.rates(time_, y_, rates)) rates.fill(std::numeric_limits<double>::quiet_NaN());
  return rates;
}

// S+ = S- + (g- - g+) dt*/dq where the rates change at a time that moves (M10.1).
void MotionRun::jump(const States& before, const States& after,
                     std::span<const double> time_slopes) {
  for (std::size_t k = 0; k < time_slopes.size(); ++k)
    for (std::size_t i = 0; i < count(); ++i)
      slopes_[k * count() + i] += (before[i] - after[i]) * time_slopes[k];
}

void MotionRun::read_slopes() {
  if (asked_.slopes) slopes_ = integrator_.slopes_at(time_);
}

// Where a turning rotor comes to rest, dt*/dq = -S_Omega / Omega' (M10.1). At a release the rates are continuous.
void MotionRun::cross_event() {
  read_slopes();
  if (!asked_.slopes || equations_.mode().held) return change_mode();
  const States before = rates_now();
  time_slopes_.resize(asked_.slopes->columns().size());
  for (std::size_t k = 0; k < time_slopes_.size(); ++k)
    time_slopes_[k] = -slopes_[k * count() + kSpeed] / before[kSpeed];
  change_mode();
  jump(before, rates_now(), time_slopes_);
}

// At rest: the rotor is held, or goes on to one side.
void MotionRun::change_mode() {
  const Mode before = equations_.mode(), after = mode_at_rest();
  equations_.set_mode(after);
  y_[kSpeed] = 0;
  if (after.held && !before.held) note(MotionEventKind::held);
  if (!after.held && before.held) {
    note(MotionEventKind::released);
    watch_.released(equations_.amplitude(time_, y_));
  }
  if (!after.held && !before.held && after.side != before.side) note(MotionEventKind::reversed);
  if (!after.held) y_[kSpeed] = after.side * kReleaseSpeed;
}

void MotionRun::take_samples() {
  while (next_sample_ < task_.output_times.size() &&
         task_.output_times[next_sample_] <= integrator_.time()) {
    const double time = task_.output_times[next_sample_++];
    const std::vector<double> y = integrator_.at(time);
    motion_.samples.push_back(sample_at(equations_, time, y));
  }
}

void MotionRun::take_speeds(double begin) {
  take_speed(motion_, y_[kSpeed]);
  if (const auto time = time_of_peak(integrator_, begin))
    take_speed(motion_, integrator_.at(*time)[kSpeed]);
}

bool MotionRun::follow(const Stretch& stretch) {
  // Times before the first step of the integrator.
  while (next_sample_ < task_.output_times.size() && task_.output_times[next_sample_] <= 0) {
    ++next_sample_;
    motion_.samples.push_back(sample_at(equations_, 0, y_));
  }
  return enter(stretch) && integrate(stretch);
}

bool MotionRun::integrate(const Stretch& stretch) {
  const auto stands = [&] { return asked_.until_held && stretch.off && equations_.mode().held; };
  if (stands()) return false;
  take_speed(motion_, y_[kSpeed]);
  integrator_.restart(time_, std::span(y_).first(count()), stretch.end, slopes_);
  while (true) {
    const double begin = time_;
    const StepEnd end = integrator_.step();
    if (end == StepEnd::failed) {
      const std::string& contact = equations_.contact().failure();
      return end_early(contact == "ok" ? "integrator-failed" : contact);
    }
    time_ = integrator_.time();
    std::ranges::copy(integrator_.y(), y_.begin());
    for (const MotionEvent& event : watch_.events(integrator_, begin))
      motion_.events.push_back(event);
    take_samples();
    take_speeds(begin);
    if (asked_.reached && asked_.reached(integrator_, begin)) return false;
    if (end == StepEnd::stop_time) {
      read_slopes();
      return true;
    }
    if (task_.go_on && !task_.go_on(time_)) return end_early("stopped");
    if (end != StepEnd::event) continue;
    cross_event();
    if (stands()) return false;
    if (time_ >= stretch.end) return true;
    integrator_.restart(time_, std::span(y_).first(count()), stretch.end, slopes_);
  }
}

Motion MotionRun::finish() {
  motion_.end = time_;
  motion_.steps = integrator_.steps();
  motion_.contacts = equations_.contact().count();
  motion_.last = sample_at(equations_, time_, y_);
  return std::move(motion_);
}

}  // namespace twum::inline v0_1::motion
