// SPDX-License-Identifier: Apache-2.0
#include "held/holding.hpp"

#include "point/operating_point.hpp"
#include "point/slice_count.hpp"

#include <twum/base/error.hpp>
#include <twum/base/no_value.hpp>
#include <twum/core/parameters.hpp>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace twum::inline v0_1::core {

Holding::Holding(const MotorDesign& design, const TrackRule& track, double speed,
                 DriveControl control)
    : modes_(stator_modes(design)),
      waves_(design, track),
      loaded_(waves_, speed),
      speed_(speed),
      control_(control) {}

HeldPoint Holding::held(double torque, Sought sought) {
  const double most = loaded_.plateau();
  const bool transmitted = std::fabs(torque) < kHeldRules.reach * most;
  if (!transmitted && !waves_.has_static_excess())
    return without_wave(HeldStatus::torque_out_of_reach, std::copysign(most, torque));
  loaded_.carry(torque);
  if (waves_.has_static_excess()) return scanned(sought);
  auto wave = straight(sought);
  if (!wave && sought == Sought::drive && follows_by_frequency()) wave = out_of_voltage();
  if (!wave) return scanned(sought);
  last_ = std::move(wave);
  return drive_of(*last_, sought);
}

// The wave with R = 0, if it needs all the voltage there is or more, but for rounding: where there is just enough, (Y2.3) is singular.
std::optional<LoadedWave> Holding::out_of_voltage() const {
  auto least = straight(Sought::least_voltage);
  const double enough = waves_.drive() * (1 - kHeldRules.settled);
  return least && least->force.force() > enough ? std::move(least) : std::nullopt;
}

// By Newton's method from the wave of the torque before, or from a likely one. Nothing where that does not lead straight to the first
// wave that carries the load, on the flank of the stator's own resonance.
std::optional<LoadedWave> Holding::straight(Sought sought) const {
  const LoadedWave* const below = last_ ? &*last_ : nullptr;
  auto wave = last_ && leads_on(*last_) ? from(*last_, sought) : std::nullopt;
  if (!wave) wave = from_likely(sought);
  if (!wave || (follows_by_frequency() && !is_on_own_side(wave->omega))) return {};
  return loaded_.is_first(*wave, below) ? std::move(wave) : std::nullopt;
}

// A layer that rings may have waves at several frequencies for one load. Which one is found must not depend on the load before.
bool Holding::leads_on(const LoadedWave& last) const {
  return !follows_by_frequency() || !loaded_.rings(last.omega);
}

// At another frequency the likely amplitude is that of a crest as fast.
std::optional<LoadedWave> Holding::from_likely(Sought sought) const {
  const double amplitude = loaded_.likely_amplitude(waves_.omega());
  const double omega = follows_by_frequency() ? likely_omega(amplitude, sought) : waves_.omega();
  auto likely = loaded_.likely(amplitude * waves_.omega() / omega, omega);
  return likely ? from(std::move(*likely), sought) : std::nullopt;
}

std::optional<LoadedWave> Holding::from(LoadedWave wave, Sought sought) const {
  return follows_by_frequency() ? by_newton(std::move(wave), sought)
                                : loaded_.solve({std::move(wave), {}, {}});
}

HeldPoint Holding::scanned(Sought sought) const {
  auto [reached, lost] = loaded_.first_reached(waves_.omega());
  if (!reached)
    return lost ? without_wave(HeldStatus::no_periodic_state)
                : without_wave(HeldStatus::torque_out_of_reach,
                               std::copysign(loaded_.plateau(), loaded_.torque()));
  if (follows_by_frequency())
    if (const auto held = by_newton(reached->near, sought)) return drive_of(*held, sought);
  auto wave = loaded_.solve(std::move(*reached));
  if (!wave) return without_wave(HeldStatus::no_periodic_state);
  return follows_by_frequency() ? at_frequency(std::move(*wave), sought) : held_point_of(*wave);
}

// (Y2.3) of the likely wave, on which the contact acts by its pressure, and from which it takes what the load would at the speed
// of the crest.
double Holding::likely_omega(double amplitude, Sought sought) const {
  const double power = std::fabs(loaded_.torque()) * waves_.crest_speed_per_amplitude() * amplitude;
  LoadedWave likely;
  likely.force =
      waves_.balance({0, power, 0, 0, 0, waves_.motor(amplitude).mean.pressure_force}, amplitude);
  const double gap = likely.force.real + flank_of(likely, sought);
  const double square = waves_.omega() * waves_.omega() + gap / (waves_.modes().mass * amplitude);
  return square > 0 ? std::sqrt(square) : waves_.omega();
}

Holding::Step Holding::newton_step(const LoadedWave& w, Sought sought) const {
  const double flank = flank_of(w, sought);
  const double turns = flank > 0 ? w.force.imaginary / flank : 0;
  const double gap = w.force.real + flank, missing = loaded_.missing(w);
  const double in_amplitude = w.in_amplitude.real - turns * w.in_amplitude.imaginary,
               in_omega = w.in_omega.real - turns * w.in_omega.imaginary;
  const double determinant = w.torque_in_amplitude * in_omega - w.torque_in_omega * in_amplitude;
  const double grown = (missing * in_omega + gap * w.torque_in_omega) / determinant,
               raised = (-gap * w.torque_in_amplitude - missing * in_amplitude) / determinant;
  return {grown, raised, std::fmax(std::fabs(grown) / w.amplitude, std::fabs(raised) / w.omega)};
}

// Both by Newton's method. Nothing where that does not lead straight there. Slopes of the wave before are off by about the step; they
// are kept where that share of what is left is no more than rounding.
std::optional<LoadedWave> Holding::by_newton(LoadedWave w, Sought sought) const {
  double last = kHeldRules.longest_newton;
  for (int i = 0; i < kHeldRules.most_newtons && w.ok() && w.torque_in_amplitude > 0; ++i) {
    const Step step = newton_step(w, sought);
    if (!(step.size < last)) return {};
    last = step.size;
    LoadedWave next = stepped(w, step, 1);
    for (int back = 1; back <= kHeldRules.most_back && LoadedWaves::on_plateau(next); ++back)
      next = stepped(w, step, std::ldexp(1.0, -back));
    if (!next.ok()) return {};
    next.take_slopes(w);
    const double left = newton_step(next, sought).size;
    if (left <= kHeldRules.settled && next.exact()) return next;
    if (left * step.size > kHeldRules.settled) loaded_.differentiate(next);
    w = std::move(next);
  }
  return {};
}

LoadedWave Holding::stepped(const LoadedWave& w, const Step& step, double share) const {
  return loaded_.found(w.amplitude + share * step.amplitude, w.omega + share * step.omega, &w,
                       LoadedWaves::accuracy_of(step.size * step.size));
}

// (Y2.3): R = -sqrt((Theta u_0)^2 - I^2) on the upper flank. Newton's method over the frequency; the amplitude follows from the
// torque. Without enough voltage it leads to R = 0, where the least is needed.
HeldPoint Holding::at_frequency(LoadedWave w, Sought sought) const {
  for (int i = 0; i < kHeldRules.most_tries; ++i) {
    loaded_.differentiate(w);
    const double flank = flank_of(w, sought);
    const double follows = -w.torque_in_omega / w.torque_in_amplitude;  // dA / domega
    const double real_slope = w.in_omega.real + w.in_amplitude.real * follows,
                 imaginary_slope = w.in_omega.imaginary + w.in_amplitude.imaginary * follows;
    const double gap = w.force.real + flank;
    double slope = real_slope;
    if (flank > 0) slope -= w.force.imaginary * imaginary_slope / flank;
    if (!(slope < 0)) slope = real_slope;  // next to R = 0 the root is steep
    double step = -gap / slope;
    const double room = kHeldRules.longest_in_frequency * w.omega;
    if (std::fabs(step) > room) step = std::copysign(room, step);
    if (std::fabs(step) <= kHeldRules.settled * w.omega) return drive_of(w, sought);
    auto next = loaded_.solve_at_frequency(w, w.omega + step);
    if (!next)
      if (auto reached = loaded_.first_reached(w.omega + step).found)
        next = loaded_.solve(std::move(*reached));
    if (!next) return without_wave(HeldStatus::no_periodic_state);
    w = std::move(*next);
  }
  return without_wave(HeldStatus::not_converged);
}

// R^2 on the flank: (Theta u_0)^2 - I^2, negative where the voltage is too low for any frequency.
double Holding::flank_squared(const LoadedWave& w, Sought sought) const {
  if (sought == Sought::least_voltage) return 0;
  return waves_.drive() * waves_.drive() - w.force.imaginary * w.force.imaginary;
}

// -R there, or at the wave that needs the least voltage.
double Holding::flank_of(const LoadedWave& w, Sought sought) const {
  const double square = flank_squared(w, sought);
  return square > 0 ? std::sqrt(square) : 0;
}

// The drive of a wave, which for (Y2.3) may be the one that needs the least voltage because there is not enough.
HeldPoint Holding::drive_of(const LoadedWave& w, Sought sought) const {
  HeldPoint found = held_point_of(w);
  if (follows_by_frequency() && flank_squared(w, sought) < 0 &&
      found.status != HeldStatus::not_converged)
    found.status = HeldStatus::voltage_too_low, found.needed = found.voltage;
  return found;
}

// A drive that follows by its frequency keeps to the flank of the stator's own resonance (D8.7).
bool Holding::is_on_own_side(double omega) const {
  const auto [lowest, highest] = waves_.own_side();
  return omega >= lowest && omega <= highest;
}

HeldPoint Holding::held_point_of(const LoadedWave& w) const {
  if (follows_by_frequency() && !is_on_own_side(w.omega))
    return without_wave(HeldStatus::not_converged);
  HeldPoint held;
  held.needed = kNoValue;
  held.amplitude = w.amplitude, held.frequency = w.omega / (2 * std::numbers::pi);
  held.voltage = modes_ ? modes_->rms_voltage(w.force.force()) : kNoValue;
  const DrivenWaves there = waves_.at_frequency(w.omega);
  held.radial_slices = waves_.model().track.nodes;
  held.point =
      operating_point_of(there.motor(w.amplitude), w.solved, speed_, modes_ ? &*modes_ : nullptr);
  if (control_ == DriveControl::amplitude) return held;
  const DrivenWaves::LevelSlopes s = there.slopes_of(w.solved, w.amplitude, speed_);
  if (!there.stability(s.in_amplitude).stable()) held.status = HeldStatus::unstable_amplitude;
  // dT / dOmega along H = Theta u_0 (D5.4): under a constant torque the speed returns where it is negative.
  held.by_control_only = !(s.torque_per_speed < 0);
  return held;
}

namespace {

void require_held(const MotorDesign& design, double speed, DriveControl control) {
  require_motor(design);
  if (!(speed > 0) || !std::isfinite(speed))
    throw InputError(
        "a torque is held at a speed of more than 0 rad/s: at rest friction holds without a wave");
  if (control != DriveControl::amplitude && !has_modal_data(design))
    throw InputError("a drive that adjusts the " +
                     std::string(control == DriveControl::voltage ? "voltage" : "frequency") +
                     " needs the stator's modal data");
  if (control == DriveControl::frequency && !design.stator.voltage)
    throw InputError("a drive that adjusts the frequency needs a voltage");
}

MotorDesign with_wave(MotorDesign design, double amplitude) {
  design.stator.voltage.reset();
  design.stator.amplitude = amplitude;  // may exceed the range of the parameter
  return design;
}

}  // namespace

HeldLine::HeldLine(const MotorDesign& design, double speed, DriveControl control)
    : design_(design), speed_(speed), control_(control) {
  require_held(design, speed, control);
  if (design.stator.radial_slices != kAutoSlices)
    holding_.emplace(design, track_rule(with_wave(design, design.stator.amplitude)), speed,
                     control);
}

HeldPoint HeldLine::held(double torque, Holding::Sought sought) {
  if (!std::isfinite(torque)) throw InputError("a held torque must be finite");
  HeldPoint held = holding_
                       ? holding_->held(torque, sought)
                       : Holding(design_, track_of(torque), speed_, control_).held(torque, sought);
  if (design_.stator.radial_slices <= kAutoSlices)
    held.radial_slices *= -1;  // as Motor::radial_slices()
  return held;
}

// The number of slices for `auto` follows from the wave that one slice has under the load.
TrackRule HeldLine::track_of(double torque) const {
  const MotorDesign one = with(design_, Parameter::radial_slices, 1);
  const TrackRule narrow = track_rule(with_wave(one, one.stator.amplitude));
  const double amplitude = Holding(one, narrow, speed_, control_).held(torque).amplitude;
  return track_rule(amplitude > 0 ? with_wave(design_, amplitude) : without_drive(design_));
}

}  // namespace twum::inline v0_1::core
