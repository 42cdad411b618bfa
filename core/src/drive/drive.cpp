// SPDX-License-Identifier: Apache-2.0
#include "drive/drive.hpp"

#include "point/slice_count.hpp"

#include <utility>

namespace twum::inline v0_1::core {
namespace {

// The number of slices for `auto` follows from the motor under the wave of one slice at first_speed(), which is near enough
// to that of the track.
TrackRule track_of(const MotorDesign& design) {
  if (design.stator.radial_slices != kAutoSlices) return track_rule(design);
  constexpr int kWithoutWave = -8;
  const double amplitude =
      Drive(with(design, Parameter::radial_slices, 1)).first_motor().mean.amplitude;
  if (!(amplitude > 0)) return track_rule(with(design, Parameter::radial_slices, kWithoutWave));
  MotorDesign given = design;  // the amplitude may exceed the range of the parameter
  given.stator.voltage.reset();
  given.stator.amplitude = amplitude;
  return track_rule(given);
}

}  // namespace

WavesAtRest::WavesAtRest(DrivenWaves waves)
    : waves_(std::move(waves)),
      line_(waves_, 0),
      extrema_(line_.extrema()),
      largest_(line_.largest_held()) {}

Drive::Drive(const MotorDesign& design, std::shared_ptr<const WavesAtRest> at_rest)
    : asked_(design.stator.branch),
      at_rest_(std::move(at_rest)),
      branch_(waves(), at_rest_->line(), at_rest_->largest(), asked_ == Branch::dead) {}

Vector<WaveSolution> Drive::solutions(double speed) const {
  Vector<WaveSolution> found = ForceLine(waves(), speed).solutions();
  for (WaveSolution& s : found)
    if (const auto runs = branch_.runs(speed, s.wave().amplitude)) s.named_running = runs;
  return found;
}

DrivenWaves Drive::waves_of(const MotorDesign& design) { return {design, track_of(design)}; }

double Drive::begin() const {
  return asked_ == Branch::running && branch_.exists() ? branch_.first().parameter : 0;
}

DrivenMotor<double> Drive::first_motor() const {
  if (asked_ == Branch::running && branch_.exists())
    return waves().motor(branch_.first().amplitude);
  const Vector<WaveSolution> at_rest = solutions(0);
  if (at_rest.empty()) return waves().motor(branch_.exists() ? branch_.first().amplitude : 0);
  const WaveSolution& chosen = asked_ == Branch::dead ? at_rest.front() : at_rest.back();
  return waves().motor(chosen.wave().amplitude);
}

MotorPoint Drive::at(double speed) const { return branch_.at(speed, asked_ == Branch::running); }

}  // namespace twum::inline v0_1::core
