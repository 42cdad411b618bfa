// SPDX-License-Identifier: Apache-2.0
#include "performance/drive/drive.hpp"

namespace twum::performance {
namespace {

// The number of slices for `auto` follows from the motor under the wave of one slice at first_speed(), which is near enough
// to that of the track.
TrackRule track_of(const MotorDesign& design) {
  if (design.stator.radial_slices != kAutoSlices) return track_rule(design);
  constexpr int kWithoutWave = -8;
  const double amplitude = Drive(with(design, Parameter::radial_slices, 1)).first_motor().amplitude;
  if (!(amplitude > 0)) return track_rule(with(design, Parameter::radial_slices, kWithoutWave));
  MotorDesign given = design;  // the amplitude may exceed the range of the parameter
  given.stator.voltage.reset();
  given.stator.amplitude = amplitude;
  return track_rule(given);
}

}  // namespace

Drive::Drive(const MotorDesign& design)
    : asked_(design.stator.branch),
      waves_(waves_of(design)),
      extrema_(force_extrema(waves_, 0)),
      branch_(waves_, extrema_) {}

DrivenWaves Drive::waves_of(const MotorDesign& design) { return {design, track_of(design)}; }

double Drive::begin() const {
  const bool above_rest = asked_ == Branch::running && branch_.lower().pulls_out();
  return above_rest ? branch_.lower().speed : 0;
}

DrivenMotor<double> Drive::first_motor() const {
  if (asked_ == Branch::running && branch_.exists()) return waves_.motor(branch_.first_amplitude());
  const std::vector<WaveSolution> at_rest = solutions(0);
  if (at_rest.empty()) return waves_.motor(branch_.exists() ? branch_.first_amplitude() : 0);
  const WaveSolution& chosen = asked_ == Branch::dead ? at_rest.front() : at_rest.back();
  return waves_.motor(chosen.wave().amplitude);
}

MotorPoint Drive::at(double speed) const {
  return asked_ == Branch::running ? running(speed) : dead(speed);
}

MotorPoint Drive::without_wave(PointStatus status) const {
  MotorPoint point{waves_.motor(0), {}};
  point.solved.status = status;
  return point;
}

MotorPoint Drive::running(double speed) const {
  if (!branch_.exists()) return without_wave(PointStatus::no_running_branch);
  std::optional<MotorPoint> point = branch_.at(speed);
  if (!point) return without_wave(PointStatus::pulled_out);
  if (!branch_.steady(*point, speed)) return without_wave(PointStatus::unstable_amplitude);
  return std::move(*point);
}

// Below the maximum of H that a start has to pass there is at most one solution.
MotorPoint Drive::dead(double speed) const {
  const std::vector<WaveSolution> all = solutions(speed);
  if (all.empty() || all.front().beyond_start()) return without_wave(PointStatus::no_dead_branch);
  if (!all.front().stability.stable()) return without_wave(PointStatus::unstable_amplitude);
  const DrivenMotor<double> motor = waves_.motor(all.front().wave().amplitude);
  return {motor, solve_point(motor, speed)};
}

}  // namespace twum::performance
