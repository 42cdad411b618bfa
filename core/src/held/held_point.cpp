// SPDX-License-Identifier: Apache-2.0
#include <twum/core/held_point.hpp>

#include "held/loaded_wave.hpp"
#include "point/operating_point.hpp"
#include "point/slice_count.hpp"

#include <twum/base/error.hpp>
#include <twum/base/no_value.hpp>
#include <twum/core/parameters.hpp>

#include <array>
#include <cmath>
#include <numbers>

namespace twum::inline v0_1 {

using namespace core;

namespace {

HeldPoint without_wave(HeldStatus status, double needed = kNoValue) {
  return {status, kNoValue, kNoValue, kNoValue, needed, false, 1, {}};
}

class Holding {
 public:
  Holding(const MotorDesign& design, const TrackRule& track, double torque, double speed,
          DriveControl control)
      : modes_(stator_modes(design)),
        waves_(design, track),
        loaded_(waves_, torque, speed),
        speed_(speed),
        control_(control) {}

  HeldPoint held() const { return search(Sought::drive); }
  HeldPoint with_least_voltage() const { return search(Sought::least_voltage); }

 private:
  // The wave of the drive's voltage (Y2.3), or that with R = 0.
  enum class Sought : bool { drive, least_voltage };

  HeldPoint search(Sought sought) const {
    const double torque = loaded_.torque(), most = loaded_.plateau();
    const bool transmitted = std::fabs(torque) < kHeldRules.reach * most;
    if (!transmitted && !waves_.has_static_excess())
      return without_wave(HeldStatus::torque_out_of_reach, std::copysign(most, torque));
    if (const auto wave = straight(sought)) return drive_of(*wave, sought);
    auto [reached, lost] = loaded_.first_reached(waves_.omega());
    if (!reached)
      return lost ? without_wave(HeldStatus::no_periodic_state)
                  : without_wave(HeldStatus::torque_out_of_reach, std::copysign(most, torque));
    if (control_ == DriveControl::frequency)
      if (const auto held = by_newton(reached->near, sought)) return drive_of(*held, sought);
    auto wave = loaded_.solve(std::move(*reached));
    if (!wave) return without_wave(HeldStatus::no_periodic_state);
    return control_ == DriveControl::frequency ? at_frequency(std::move(*wave), sought)
                                               : held_point_of(*wave);
  }

  // From a likely wave by Newton's method. Nothing where that does not lead straight to the first wave that carries the load.
  std::optional<LoadedWave> straight(Sought sought) const {
    const bool follows = control_ == DriveControl::frequency;
    auto wave = loaded_.likely(follows ? likely_omega(sought) : waves_.omega());
    if (!wave) return {};
    wave = follows ? by_newton(std::move(*wave), sought) : loaded_.solve({std::move(*wave), {}, {}});
    return wave && loaded_.is_first(*wave) ? wave : std::nullopt;
  }

  // (Y2.3) of the likely wave, on which the contact acts by its pressure, and from which it takes what the load would at the speed
  // of the crest.
  double likely_omega(Sought sought) const {
    const double amplitude = loaded_.likely_amplitude(waves_.omega());
    const double power =
        std::fabs(loaded_.torque()) * waves_.crest_speed_per_amplitude() * amplitude;
    LoadedWave likely;
    likely.force = waves_.balance(
        {0, power, 0, 0, 0, waves_.motor(amplitude).mean.pressure_force}, amplitude);
    const double gap = likely.force.real + flank_of(likely, sought);
    const double square =
        waves_.omega() * waves_.omega() + gap / (waves_.modes().mass * amplitude);
    return square > 0 ? std::sqrt(square) : waves_.omega();
  }

  // A step of Newton's method for (Y2.1) together with (Y2.3) or R = 0.
  struct Step {
    double amplitude, omega;
    double size;  ///< the larger of both, of themselves
  };
  // From a wave, with its derivatives or those of one nearby.
  Step newton_step(const LoadedWave& w, const LoadedWave& slopes, Sought sought) const {
    const double flank = flank_of(w, sought);
    const double turns = flank > 0 ? w.force.imaginary / flank : 0;
    const double gap = w.force.real + flank, missing = loaded_.missing(w);
    const double in_amplitude = slopes.in_amplitude.real - turns * slopes.in_amplitude.imaginary,
                 in_omega = slopes.in_omega.real - turns * slopes.in_omega.imaginary;
    const double determinant =
        slopes.torque_in_amplitude * in_omega - slopes.torque_in_omega * in_amplitude;
    const double grown = (missing * in_omega + gap * slopes.torque_in_omega) / determinant,
                 raised =
                     (-gap * slopes.torque_in_amplitude - missing * in_amplitude) / determinant;
    return {grown, raised,
            std::fmax(std::fabs(grown) / w.amplitude, std::fabs(raised) / w.omega)};
  }

  // Both by Newton's method. Nothing where that does not lead straight there.
  std::optional<LoadedWave> by_newton(LoadedWave w, Sought sought) const {
    double last = kHeldRules.longest_newton;
    for (int i = 0; i < kHeldRules.most_newtons && w.ok() && w.torque_in_amplitude > 0; ++i) {
      const Step step = newton_step(w, w, sought);
      if (!(step.size < last)) return {};
      last = step.size;
      LoadedWave next = loaded_.found(w.amplitude + step.amplitude, w.omega + step.omega, &w);
      if (!next.ok()) return {};
      next.torque_in_amplitude = w.torque_in_amplitude;
      if (newton_step(next, w, sought).size <= kHeldRules.settled) return next;
      loaded_.differentiate(next);
      w = std::move(next);
    }
    return {};
  }

  // (Y2.3): R = -sqrt((Theta u_0)^2 - I^2) on the upper flank. Newton's method over the frequency; the amplitude follows from the
  // torque. Without enough voltage it leads to R = 0, where the least is needed.
  HeldPoint at_frequency(LoadedWave w, Sought sought) const {
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
  double flank_squared(const LoadedWave& w, Sought sought) const {
    if (sought == Sought::least_voltage) return 0;
    return waves_.drive() * waves_.drive() - w.force.imaginary * w.force.imaginary;
  }

  // -R there, or at the wave that needs the least voltage.
  double flank_of(const LoadedWave& w, Sought sought) const {
    const double square = flank_squared(w, sought);
    return square > 0 ? std::sqrt(square) : 0;
  }

  // The drive of a wave, which for (Y2.3) may be the one that needs the least voltage because there is not enough.
  HeldPoint drive_of(const LoadedWave& w, Sought sought) const {
    HeldPoint found = held_point_of(w);
    if (control_ == DriveControl::frequency && flank_squared(w, sought) < 0 && found.status != HeldStatus::not_converged)
      found.status = HeldStatus::voltage_too_low, found.needed = found.voltage;
    return found;
  }

  // A drive that follows by its frequency keeps to the flank of the stator's own resonance (D8.7).
  bool is_on_own_side(double omega) const {
    const auto [lowest, highest] = waves_.own_side();
    return omega >= lowest && omega <= highest;
  }

  HeldPoint held_point_of(const LoadedWave& w) const {
    if (control_ == DriveControl::frequency && !is_on_own_side(w.omega))
      return without_wave(HeldStatus::not_converged);
    HeldPoint held;
    held.needed = kNoValue;
    held.amplitude = w.amplitude, held.frequency = w.omega / (2 * std::numbers::pi);
    held.voltage = modes_ ? modes_->rms_voltage(w.force.force()) : kNoValue;
    const DrivenWaves there = waves_.at_frequency(w.omega);
    held.radial_slices = waves_.model().track.nodes;
    held.point = operating_point_of(there.motor(w.amplitude), w.solved, speed_,
                                    modes_ ? &*modes_ : nullptr);
    if (control_ == DriveControl::amplitude) return held;
    const DrivenWaves::LevelSlopes s = there.slopes_of(w.solved, w.amplitude, speed_);
    if (!there.stability(s.in_amplitude).stable()) held.status = HeldStatus::unstable_amplitude;
    // dT / dOmega along H = Theta u_0 (D5.4): under a constant torque the speed returns where it is negative.
    held.by_control_only = !(s.torque_per_speed < 0);
    return held;
  }

  std::optional<StatorModes<double>> modes_;
  DrivenWaves waves_;
  LoadedWaves loaded_;
  double speed_;
  DriveControl control_;
};

MotorDesign with_wave(MotorDesign design, double amplitude) {
  design.stator.voltage.reset();
  design.stator.amplitude = amplitude;  // may exceed the range of the parameter
  return design;
}

// The number of slices for `auto` follows from the wave that one slice has under the load.
TrackRule track_of(const MotorDesign& design, double torque, double speed, DriveControl control) {
  if (design.stator.radial_slices != kAutoSlices)
    return track_rule(with_wave(design, design.stator.amplitude));
  const MotorDesign one = with(design, Parameter::radial_slices, 1);
  const TrackRule narrow = track_rule(with_wave(one, one.stator.amplitude));
  const double amplitude = Holding(one, narrow, torque, speed, control).held().amplitude;
  if (amplitude > 0) return track_rule(with_wave(design, amplitude));
  return track_rule(without_drive(design));
}

// As Motor::radial_slices().
HeldPoint of_design(const MotorDesign& design, HeldPoint held) {
  if (design.stator.radial_slices <= kAutoSlices) held.radial_slices *= -1;
  return held;
}

}  // namespace

const char* to_string(HeldStatus status) noexcept {
  switch (status) {
    case HeldStatus::ok: return "ok";
    case HeldStatus::torque_out_of_reach: return "torque-out-of-reach";
    case HeldStatus::voltage_too_low: return "voltage-too-low";
    case HeldStatus::amplitude_too_low: return "amplitude-too-low";
    case HeldStatus::outside_frequency_range: return "outside-frequency-range";
    case HeldStatus::unstable_amplitude: return "unstable-amplitude";
    case HeldStatus::no_periodic_state: return "no-periodic-state";
    case HeldStatus::not_converged: return "not-converged";
  }
  return "not-converged";
}

namespace {

void require_held(const MotorDesign& design, double torque, double speed, DriveControl control) {
  require_motor(design);
  if (!std::isfinite(torque)) throw InputError("a held torque must be finite");
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

}  // namespace

HeldPoint held_point(const MotorDesign& design, double torque, double speed, DriveControl control) {
  require_held(design, torque, speed, control);
  return of_design(
      design,
      Holding(design, track_of(design, torque, speed, control), torque, speed, control).held());
}

HeldPoint held_point(const MotorDesign& design, double torque, double speed) {
  const Stator& stator = design.stator;
  const DriveControl control = stator.voltage ? stator.control : DriveControl::amplitude;
  HeldPoint held = held_point(design, torque, speed, control);
  if (held.status != HeldStatus::ok) return held;
  const auto refused = [&](HeldStatus status, double needed) {
    held.status = status, held.needed = needed;
  };
  switch (control) {
    case DriveControl::amplitude:
      if (held.amplitude > stator.amplitude) refused(HeldStatus::amplitude_too_low, held.amplitude);
      break;
    case DriveControl::voltage:
      if (held.voltage > *stator.voltage) refused(HeldStatus::voltage_too_low, held.voltage);
      break;
    case DriveControl::frequency:
      if (const auto& range = stator.frequency_range;
          range && !(held.frequency >= range->first && held.frequency <= range->second))
        refused(HeldStatus::outside_frequency_range, held.frequency);
      break;
  }
  return held;
}

HeldPoint least_voltage_point(const MotorDesign& design, double torque, double speed) {
  constexpr DriveControl kControl = DriveControl::frequency;
  require_held(design, torque, speed, kControl);
  return of_design(
      design, Holding(design, track_of(design, torque, speed, kControl), torque, speed, kControl)
                  .with_least_voltage());
}

double largest_held_torque(const MotorDesign& design) {
  require_motor(design);
  return LoadedWaves({design, track_rule(without_drive(design))}, 0, 0).plateau();
}

MotorDesign with_held_wave(const MotorDesign& design, const HeldPoint& held) {
  return with(design, std::array<ParameterValue, 3>{
                          {{Parameter::amplitude, held.amplitude},
                           {Parameter::frequency, held.frequency},
                           {Parameter::radial_slices, static_cast<double>(held.radial_slices)}}});
}

}  // namespace twum::inline v0_1
