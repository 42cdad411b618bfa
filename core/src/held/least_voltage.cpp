// SPDX-License-Identifier: Apache-2.0
#include "held/least_voltage.hpp"

#include "drive/drive.hpp"
#include "drive/force_line.hpp"
#include "held/holding.hpp"
#include "point/slice_count.hpp"

#include <twum/base/no_value.hpp>
#include <twum/base/scalar_search.hpp>
#include <twum/core/parameters.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace twum::inline v0_1::core {
namespace {

// How the speeds are sampled at which a motor may carry a torque.
struct SpeedSamples {
  /// The highest crest is that of this many amplitudes of full contact, or of this many of the largest wave under the design's
  /// voltage (D2.7), whichever is more: there the stator alone asks for the voltage, which rises with the speed.
  double full_contacts{400}, largest_waves{2};
  /// Each speed of the one before.
  double next{0.7};
  /// Down to a crest of 1e-6 of the first, where the motor is as good as at rest.
  int most{39};
  /// Share of the largest torque beyond which no wave is sought: its amplitude would grow without bound.
  double transmitted{0.99};
  /// Bits of the speed. The voltage is least there, so that it is right to twice as many.
  int bits{20};
};
constexpr SpeedSamples kSamples;

// From high speeds down, the voltage falls to that at which the running wave ends, rises towards the waves between running and dead
// ones, and falls again with those that are dead: the first minimum is the one.
LeastVoltage first_minimum(const MotorDesign& design, double torque) {
  const DrivenWaves waves(design, track_rule(without_drive(design)));
  const auto wave_at = [&](double speed) {
    return held_point(design, torque, speed, DriveControl::voltage);
  };
  const auto voltage = [&](double speed) { return wave_at(speed).voltage; };
  const double highest = waves.crest_speed_per_amplitude() *
                         std::max(kSamples.full_contacts * waves.full_contact_amplitude(),
                                  kSamples.largest_waves * largest_amplitude(waves));
  double faster = highest, speed = highest, least = HUGE_VAL;
  for (int k = 0; k < kSamples.most; ++k) {
    const double slower = kSamples.next * speed, needs = voltage(slower);
    if (needs > least) {
      const double place = least_between("the speed at which a torque needs the least voltage",
                                         voltage, slower, faster, kSamples.bits)
                               .place;
      return {wave_at(place), place};
    }
    if (!std::isnan(needs)) least = needs;
    faster = speed, speed = slower;
  }
  return {wave_at(speed), speed};
}

// Vertices of parabolas through three speeds, the second time closer: the voltage there is right to the fourth power of what the
// first one missed. Nothing if the minimum is not nearby.
std::optional<LeastVoltage> minimum_near(const MotorDesign& design, double torque, double near) {
  const auto voltage = [&](double speed) {
    return held_point(design, torque, speed, DriveControl::voltage).voltage;
  };
  double place = near;
  for (const double step : {0.1, 0.01}) {
    const double h = step * place, left = voltage(place - h), middle = voltage(place),
                 right = voltage(place + h);
    const double moved = 0.5 * h * (left - right) / (left - 2 * middle + right);
    if (!(left - 2 * middle + right > 0) || !(std::fabs(moved) <= 2 * h)) return {};
    place += moved;
  }
  return LeastVoltage{held_point(design, torque, place, DriveControl::voltage), place};
}

}  // namespace

// A track of slices has its minimum next to that of one slice, which costs little.
LeastVoltage least_voltage_at_torque(const MotorDesign& design, double torque) {
  if (std::fabs(torque) > kSamples.transmitted * largest_held_torque(design))
    return {without_wave(HeldStatus::torque_out_of_reach), kNoValue};
  if (design.stator.radial_slices == 1) return first_minimum(design, torque);
  const LeastVoltage one = first_minimum(with(design, Parameter::radial_slices, 1), torque);
  if (one.wave.voltage > 0)
    if (const auto found = minimum_near(design, torque, one.speed)) return *found;
  return first_minimum(design, torque);
}

LeastVoltage least_voltage_at_speed(const MotorDesign& design, double speed) {
  const DrivenWaves waves = Drive::waves_of(design);
  std::optional<ForceExtremum> lowest;  // of the waves beyond the last maximum
  for (const ForceExtremum& one : ForceLine(waves, speed).extrema())
    if (!one.maximum) lowest = one;
  // With jumps of H (mu_0 > mu) the wave may end at one of them, which need not be a minimum.
  if (!lowest || waves.has_static_excess()) return {without_wave(HeldStatus::ok), speed};
  // At the fold the determinant is zero, so that the trace decides (D2.6).
  if (!(waves.stability(waves.in_amplitude(lowest->amplitude, speed)).trace < 0))
    return {without_wave(HeldStatus::unstable_amplitude), speed};
  HeldPoint wave = without_wave(HeldStatus::ok);
  wave.amplitude = lowest->amplitude;
  wave.frequency = drive_frequency(design);
  wave.voltage = waves.modes().rms_voltage(lowest->force);
  const int nodes = waves.model().track.nodes;
  wave.radial_slices = design.stator.radial_slices <= kAutoSlices ? -nodes : nodes;
  // a speed as good as rest, where the derivatives need one
  const double turning = 1e-9 * waves.crest_speed_per_amplitude() * wave.amplitude;
  return {wave, std::max(speed, turning)};
}

}  // namespace twum::inline v0_1::core
