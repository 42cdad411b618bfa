// SPDX-License-Identifier: Apache-2.0
#include "held/envelope.hpp"

#include "drive/driven_wave.hpp"
#include "held/holding.hpp"
#include "point/slice_count.hpp"

#include <twum/base/error.hpp>
#include <twum/base/no_value.hpp>
#include <twum/base/scalar_search.hpp>
#include <twum/core/parameters.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace twum::inline v0_1::core {
namespace {

// Of the largest torque: T_p - T goes with the cube of A_p - A, so that the last of it is left out.
constexpr double kTop = 1 - 2e-6;
// Torques that are tried from the largest down to the largest of a load that drives.
constexpr int kTorques = 24;
// Speeds that are tried from the highest down: each of the one before, and at most this many.
constexpr double kNextSpeed = 0.93;
constexpr int kSpeeds = 160;
// Doublings of the speed where nothing bounds it.
constexpr int kDoublings = 40;
// Where a drive that holds nothing is asked why [rad/s].
constexpr double kAnySpeed = 1;
// Bits of the corner's place.
constexpr int kBits = 46;

double share_over(double has, double needs) { return needs > 0 ? has / needs - 1 : kNoValue; }

HeldStatus status_at(DriveEnd end) {
  switch (end) {
    case DriveEnd::friction: return HeldStatus::torque_out_of_reach;
    case DriveEnd::voltage: return HeldStatus::voltage_too_low;
    case DriveEnd::upper_flank: return HeldStatus::unstable_amplitude;
    case DriveEnd::amplitude: return HeldStatus::amplitude_too_low;
    case DriveEnd::frequency: return HeldStatus::outside_frequency_range;
  }
  return HeldStatus::not_converged;
}

}  // namespace

double flank_lag(const MotorDesign& design, const HeldPoint& held) {
  const auto modes = stator_modes(design);
  if (!modes) return held.point.phase_lag;
  return held.point.phase_lag - divider_lag(*modes, 2 * std::numbers::pi * held.frequency);
}

Envelope::Envelope(const MotorDesign& design)
    : design_(design), control_(control_of(design.stator)), largest_(largest_held_torque(design)) {}

double Envelope::with_wave(double torque) const {
  return std::clamp(torque, -kNearlyAll * largest_, kNearlyAll * largest_);
}

HeldLine Envelope::line(double speed) const { return {design_, speed, control_}; }

DriveReserve Envelope::by_frequency(HeldLine& line, double torque) const {
  const HeldPoint least = line.held(torque, Holding::Sought::least_voltage);
  DriveReserve reserve{share_over(*design_.stator.voltage, least.voltage), DriveEnd::voltage,
                       least};
  const auto& range = design_.stator.frequency_range;
  if (!range || !(least.frequency > 0)) return reserve;
  const HeldPoint wave = reserve.share > 0 ? line.held(torque) : least;
  const double inside =
      std::min(wave.frequency / range->first - 1, 1 - wave.frequency / range->second);
  if (inside < reserve.share) reserve = {inside, DriveEnd::frequency, wave};
  return reserve;
}

DriveReserve Envelope::reserve(HeldLine& line, double torque) const {
  if (control_ == DriveControl::frequency) return by_frequency(line, torque);
  const HeldPoint wave = line.held(torque);
  if (control_ == DriveControl::amplitude)
    return {share_over(design_.stator.amplitude, wave.amplitude), DriveEnd::amplitude, wave};
  const double share = share_over(*design_.stator.voltage, wave.voltage);
  const double flank = -std::cos(flank_lag(design_, wave));  // -R / H
  if (flank < share) return {flank, DriveEnd::upper_flank, wave};
  return {share, DriveEnd::voltage, wave};
}

DriveReserve Envelope::reserve(double torque, double speed) const {
  HeldLine at_speed = line(speed);
  return reserve(at_speed, torque);
}

Envelope::Corner Envelope::corner(double torque, double speed) const {
  const DriveReserve there = reserve(torque, speed);
  return {HeldStatus::ok, torque, speed, there.end, there.wave};
}

Envelope::Corner Envelope::out_of_reach(double torque, double speed) const {
  const DriveReserve there = reserve(torque, speed);
  const HeldStatus status = std::isnan(there.share) ? there.wave.status : status_at(there.end);
  return {status == HeldStatus::ok ? HeldStatus::no_periodic_state : status, kNoValue, kNoValue,
          there.end, there.wave};
}

Envelope::Corner Envelope::at_speed(double speed) const {
  const double top = kTop * largest_;
  HeldLine waves = line(speed);
  const auto share_at = [&](double torque) { return reserve(waves, torque).share; };
  double high = top, at_high = share_at(high);
  if (at_high >= 0) return {HeldStatus::ok, largest_, speed, DriveEnd::friction, {}};
  for (int k = 1; k <= kTorques; ++k) {
    const double low = top * (1 - 2.0 * k / kTorques), at_low = share_at(low);
    if (at_low >= 0 && at_high < 0)
      return corner(closed_in("the largest torque held at a speed", share_at,
                              {low, high, at_low, at_high}, kBits)
                        .nearest(),
                    speed);
    high = low, at_high = at_low;
  }
  return out_of_reach(0, speed);
}

// A load that brakes needs a crest faster than the rotor, somewhere on the track, and the drive overcomes at least the loss of the
// stator: omega A is at most Theta u_0 / d_s. A motor without loss, one that a load drives, or one with an inductance in front of it
// has no such bound.
double Envelope::highest_speed(double torque) const {
  constexpr double kAcross = 2;  // crest over rotor speed across a track, at most
  const DrivenWaves waves(design_, track_rule(without_drive(design_)));
  const double per_amplitude = waves.crest_speed_per_amplitude();
  if (torque >= 0 && control_ == DriveControl::amplitude)
    return kAcross * per_amplitude * design_.stator.amplitude;
  if (torque >= 0 && waves.modes().damping > 0 && !waves.modes().has_series())
    return kAcross * per_amplitude / waves.omega() * waves.drive() / waves.modes().damping;
  double speed = 1, last_held = 1;
  for (int k = 0; k < kDoublings && speed < 64 * last_held; ++k, speed *= 2)
    if (reserve(torque, speed).share >= 0) last_held = speed;
  return speed;
}

Envelope::Corner Envelope::at_torque(double torque) const {
  if (!(std::fabs(torque) <= kTop * largest_)) {
    Corner none{HeldStatus::torque_out_of_reach, kNoValue, kNoValue, DriveEnd::friction, {}};
    none.wave.needed = largest_;
    return none;
  }
  const auto share_at = [&](double speed) { return reserve(torque, speed).share; };
  double high = highest_speed(torque);
  if (!(high > 0)) return out_of_reach(torque, kAnySpeed);  // no voltage or amplitude at all
  double at_high = share_at(high);
  for (int k = 0; k < kSpeeds; ++k) {
    const double low = kNextSpeed * high, at_low = share_at(low);
    if (at_low >= 0 && at_high < 0)
      return corner(torque, closed_in("the largest speed at which a torque is held", share_at,
                                      {low, high, at_low, at_high}, kBits)
                                .nearest());
    high = low, at_high = at_low;
  }
  return out_of_reach(torque, high);
}

}  // namespace twum::inline v0_1::core
