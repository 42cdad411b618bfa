// SPDX-License-Identifier: Apache-2.0
#include "held/holding.hpp"

#include "held/torque_law.hpp"
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
    : waves_(design, track),
      modes_(has_modal_data(design) ? &waves_.modes() : nullptr),
      loaded_(waves_, speed),
      speed_(speed),
      control_(control) {}

FirstWave Holding::first(Sought sought) const {
  if (!follows_by_frequency()) return {loaded_, {waves_.omega()}};
  return {loaded_, {waves_.omega(), sought == Sought::drive ? waves_.drive() : 0}};
}

HeldPoint Holding::held(double torque, Sought sought) {
  const double most = loaded_.plateau();
  const bool transmitted = std::fabs(torque) < kHeldRules.reach * most;
  if (!transmitted && !loaded_.jumps())
    return without_wave(HeldStatus::torque_out_of_reach, std::copysign(most, torque));
  loaded_.carry(torque);
  const FirstWave wanted = first(sought), least = first(Sought::least_voltage);
  const bool by_frequency = follows_by_frequency() && sought == Sought::drive;
  if (!loaded_.jumps()) {
    auto wave = straight(wanted);
    if (!wave && by_frequency) wave = near_least_voltage(straight(least), wanted);
    if (wave) {
      last_ = std::move(wave), last_path_ = wanted.path();
      return drive_of(*last_, sought);
    }
  }
  Scan scan = scanned(wanted);
  const bool out_of_reach = scan.missed == HeldStatus::torque_out_of_reach;
  if (!scan.wave && by_frequency && !out_of_reach)
    scan.wave = near_least_voltage(scanned(least).wave, wanted);
  if (scan.wave) return drive_of(*scan.wave, sought);
  return without_wave(scan.missed, out_of_reach ? std::copysign(most, torque) : kNoValue);
}

// The wave with R = 0, if it needs all the voltage there is or more, but for rounding. Where there is little more (Y2.3) is nearly
// singular, and Newton's method needs a better start: along (Y2.1) R and I go on from that wave to the voltage.
std::optional<LoadedWave> Holding::near_least_voltage(std::optional<LoadedWave> least,
                                                      const FirstWave& wanted) const {
  if (!least || least->force.force() > waves_.drive() * (1 - kHeldRules.just_enough)) return least;
  loaded_.differentiate(*least);
  const LoadedWave& w = *least;
  if (!(w.torque_in_amplitude > 0)) return {};
  const double follows = -w.torque_in_omega / w.torque_in_amplitude;
  const double real = w.in_omega.real + follows * w.in_amplitude.real,
               imaginary = w.in_omega.imaginary + follows * w.in_amplitude.imaginary;
  const double square = real * real + imaginary * imaginary,
               half = w.force.real * real + w.force.imaginary * imaginary,
               missing = waves_.drive() * waves_.drive() - w.force.force() * w.force.force();
  const double step = (std::sqrt(half * half + square * missing) - half) / square;
  LoadedWave start = loaded_.at(w.amplitude + follows * step, w.omega + step, &w);
  auto wave = start.ok() ? by_newton(std::move(start), wanted.path()) : std::nullopt;
  if (!wave) return {};
  const bool close = waves_.drive() < (1 + kHeldRules.near_least) * w.force.force();
  const bool first =
      !close ? wanted.is(*wave, nullptr) : loaded_.jumps() || is_first_of_frequency(*wave, nullptr);
  return first ? std::move(wave) : std::nullopt;
}

// Where R is zero, or nearly so, the waves of a flank turn back: A falls with omega. Those of one frequency do not.
bool Holding::is_first_of_frequency(const LoadedWave& wave, const LoadedWave* lower) const {
  return FirstWave(loaded_, {wave.omega}).is(wave, lower);
}

// By Newton's method from the wave of the torque before, or from a likely one. Nothing where that does not lead straight to the first
// wave that carries the load, on the flank of the stator's own resonance.
std::optional<LoadedWave> Holding::straight(const FirstWave& first) const {
  const bool same_path = last_ && last_path_ == first.path();
  const LoadedWave* const below = same_path ? &*last_ : nullptr;
  auto wave = last_ ? from(*last_, first) : std::nullopt;
  if (!wave) wave = from_likely(first);
  if (!wave || (follows_by_frequency() && !is_on_own_side(wave->omega))) return {};
  const bool is_first =
      first.path().drive == 0 ? is_first_of_frequency(*wave, below) : first.is(*wave, below);
  return is_first ? std::move(wave) : std::nullopt;
}

std::optional<LoadedWave> Holding::from_likely(const FirstWave& first) const {
  const LikelyWave wave = likely_wave(first.path());
  auto likely = loaded_.likely(wave.amplitude, wave.omega);
  return likely ? from(std::move(*likely), first) : std::nullopt;
}

std::optional<LoadedWave> Holding::from(LoadedWave wave, const FirstWave& first) const {
  return follows_by_frequency() ? by_newton(std::move(wave), first.path())
                                : first.solve({std::move(wave), {}, {}});
}

Holding::Scan Holding::scanned(const FirstWave& first) const {
  auto [reached, missed] = first.reached();
  if (!reached) return {{}, missed};
  if (follows_by_frequency())
    if (auto held = by_newton(reached->near, first.path()); held && reached->encloses(*held))
      return {std::move(held), HeldStatus::ok};
  const bool singular = follows_by_frequency() && !loaded_.jumps();
  return {first.solve(std::move(*reached)),
          singular ? HeldStatus::not_converged : HeldStatus::no_periodic_state};
}

// At a frequency nearby the crest is as fast. Far from that of the design once more from there.
Holding::LikelyWave Holding::likely_wave(const WavePath& path) const {
  const double designed = path.omega, amplitude = loaded_.likely_amplitude(designed);
  if (!path.drive) return {amplitude, designed};
  const double omega = likely_omega({amplitude, designed}, path);
  if (std::fabs(omega - designed) <= kHeldRules.nearby * designed)
    return {amplitude * designed / omega, omega};
  const double there = loaded_.likely_amplitude(omega), last = likely_omega({there, omega}, path);
  return {there * omega / last, last};
}

// (Y2.3) for a wave whose contact takes what the load would at the speed of the crest.
double Holding::likely_omega(const LikelyWave& wave, const WavePath& path) const {
  const DrivenWaves there = waves_.at_frequency(wave.omega);
  const DrivenMotor<double> motor = there.motor(wave.amplitude);
  const double power = std::fabs(loaded_.torque()) * motor.mean.crest_velocity / motor.mean.radius;
  const double force = motor.mean.pressure_force +
                       likely_traction(motor, speed_, loaded_.torque() / loaded_.plateau());
  LoadedWave likely;
  likely.force = there.balance({0, power, 0, 0, 0, force}, wave.amplitude);
  return loaded_.omega_beside(wave.omega, path.above_flank(likely), wave.amplitude);
}

Holding::Step Holding::newton_step(const LoadedWave& w, const WavePath& path) const {
  const double gap = path.above_flank(w), missing = loaded_.missing(w);
  const double in_amplitude = path.slope_above_flank(w, w.in_amplitude),
               in_omega = path.slope_above_flank(w, w.in_omega);
  const double determinant = w.torque_in_amplitude * in_omega - w.torque_in_omega * in_amplitude;
  const double grown = (missing * in_omega + gap * w.torque_in_omega) / determinant,
               raised = (-gap * w.torque_in_amplitude - missing * in_amplitude) / determinant;
  return {grown, raised, std::fmax(std::fabs(grown) / w.amplitude, std::fabs(raised) / w.omega)};
}

// Both by Newton's method. Nothing where that does not lead straight there. Slopes of the wave before are off by about the step; they
// are kept where that share of what is left is no more than rounding.
std::optional<LoadedWave> Holding::by_newton(LoadedWave w, const WavePath& path) const {
  Step step = newton_step(w, path);
  double last = kHeldRules.longest_newton;
  for (int i = 0; i < kHeldRules.most_newtons && w.ok() && w.torque_in_amplitude > 0; ++i) {
    if (!(step.size < last)) return {};
    LoadedWave next = stepped(w, step, 1);
    for (int back = 1; back <= kHeldRules.most_back && LoadedWaves::on_plateau(next); ++back)
      next = stepped(w, step, std::ldexp(1.0, -back));
    if (!next.ok()) return {};
    next.take_slopes(std::move(w));
    Step left = newton_step(next, path);
    if (left.size <= kHeldRules.settled && next.exact()) return next;
    if (left.size * step.size > kHeldRules.settled) {
      loaded_.differentiate(next);
      left = newton_step(next, path);
    }
    last = step.size, step = left, w = std::move(next);
  }
  return {};
}

LoadedWave Holding::stepped(const LoadedWave& w, const Step& step, double share) const {
  return loaded_.found(w.amplitude + share * step.amplitude, w.omega + share * step.omega, &w,
                       LoadedWaves::accuracy_of(step.size * step.size));
}

// The drive of a wave, which for (Y2.3) may be the one that needs the least voltage because there is not enough.
HeldPoint Holding::drive_of(const LoadedWave& w, Sought sought) const {
  HeldPoint found = held_point_of(w);
  const bool too_low = follows_by_frequency() && sought == Sought::drive &&
                       std::fabs(w.force.imaginary) > waves_.drive();
  if (too_low && found.status != HeldStatus::not_converged)
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
      operating_point_of(there.motor(w.amplitude, w.solved.half_angle), w.solved, speed_, modes_);
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
  const int slices = design.stator.radial_slices;
  if (slices == kAutoSlices) return;
  const TrackRule track = slices > kAutoSlices
                              ? track_rule(design)
                              : track_rule(with_wave(design, design.stator.amplitude));
  holding_.emplace(design, track, speed, control);
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
