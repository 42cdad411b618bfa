// SPDX-License-Identifier: Apache-2.0
#include <twum/base/no_value.hpp>
#include <twum/core/motor.hpp>

#include "design/held_traps.hpp"
#include "design/workspace.hpp"
#include "drive/lazy_drive.hpp"
#include "point/fields.hpp"
#include "point/operating_point.hpp"
#include "point/point.hpp"
#include "point/slice_count.hpp"

#include <twum/core/parameters.hpp>
#include <twum/core/plate.hpp>

#include <twum/base/error.hpp>

#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <string>
#include <utility>

namespace twum::inline v0_1 {
namespace {

// A motor that an evaluation makes lives in its workspace.
template <typename T, typename... Arguments>
std::shared_ptr<const T> shared(Arguments&&... arguments) {
  return std::allocate_shared<const T>(core::FromWorkspace<T>(),
                                       std::forward<Arguments>(arguments)...);
}

std::string speed_text(double speed) {
  char text[64];
  std::snprintf(text, sizeof text, "%.6g rad/s (%.6g rpm)", speed, speed * 30 / std::numbers::pi);
  return text;
}

}  // namespace

Motor::Motor(const MotorDesign& asked) : design_(asked) {
  const core::HeldTraps held;
  keep_plate(design_);
  const MotorDesign& design = design_;
  require_motor(design);
  if (const auto modes = core::stator_modes(design))
    modes_ = shared<core::StatorModes<double>>(*modes);
  if (design.stator.voltage) {
    drive_ = shared<core::LazyDrive>(design);
    return;
  }
  const auto values = core::model_values(design);
  model_ = shared<core::DrivenMotor<double>>(
      driven(core::motor_model(values, core::track_rule(design)), core::design_wave(values)));
}

const core::Drive* Motor::drive() const { return drive_ ? &drive_->drive() : nullptr; }

const core::DrivenMotor<double>& Motor::model() const { return drive_ ? drive_->model() : *model_; }

int Motor::radial_slices() const {
  const int nodes = model().track.nodes;
  return design_.stator.radial_slices <= kAutoSlices ? -nodes : nodes;
}

bool Motor::slices_settled() const { return model().track.settled; }

std::vector<double> Motor::slice_radii() const {
  std::vector<double> radii;
  for (const core::Slice<double>& slice : model().slices()) radii.push_back(slice.radius);
  return radii;
}

const NormalContact<double>& Motor::contact() const { return model().mean.contact; }

double Motor::first_speed() const { return drive_ ? drive()->begin() : 0; }

double Motor::crest_speed() const { return model().mean.crest_velocity / model().r; }

double Motor::wave_speed() const { return model().omega / model().kappa / model().r; }

double Motor::holding_torque() const { return core::holding_torque(model()); }

bool Motor::locks_at_rest() const { return core::locks_at_rest(model()); }

namespace {

void require_speed(const core::DrivenMotor<double>& m, double speed) {
  if (!core::wave_meets_rotor(m, speed)) {
    throw InputError("rotor speed must be more than the wave's backward speed, " +
                     speed_text(-m.omega / m.kappa / m.r) + ", but is " + speed_text(speed));
  }
}

}  // namespace

core::MotorPoint Motor::solved(double speed) const {
  require_speed(model(), speed);
  if (drive_) return drive()->at(speed);
  return {model(), core::solve_point(model(), speed)};
}

OperatingPoint Motor::operating_point(double speed) const {
  const core::HeldTraps held;
  require_speed(model(), speed);
  if (!drive_)
    return core::operating_point_of(model(), core::solve_point(model(), speed), speed,
                                    modes_.get());
  const core::MotorPoint at = drive()->at(speed);
  return core::operating_point_of(at.motor, at.solved, speed, modes_.get());
}

OperatingPoint Motor::operating_point(const OperatingConditions& at) const {
  const core::HeldTraps held;
  require_admissible(Parameter::amplitude, at.amplitude);
  require_admissible(Parameter::frequency, at.frequency);
  const core::DrivenMotor<double> m =
      driven<double>(model(), {at.amplitude, 2 * std::numbers::pi * at.frequency});
  require_speed(m, at.speed);
  return core::operating_point_of(m, core::solve_point(m, at.speed), at.speed, modes_.get());
}

#ifndef __wasm__
OperatingPoint Motor::operating_point(double speed, Workspace& workspace) const {
  const core::WorkIn scope(workspace);
  return operating_point(speed);
}

OperatingPoint Motor::operating_point(const OperatingConditions& at, Workspace& workspace) const {
  const core::WorkIn scope(workspace);
  return operating_point(at);
}
#endif

namespace {

void require_on_track(const core::DrivenMotor<double>& m, double radius) {
  const double slack = 1e-12 * m.r;  // of radii that were added and subtracted
  if (std::fabs(radius - m.r) <= 0.5 * m.b + slack) return;
  char text[120];
  std::snprintf(text, sizeof text,
                "radius must be on the contact track, %.6g to %.6g mm, but is %.6g mm",
                1e3 * (m.r - 0.5 * m.b), 1e3 * (m.r + 0.5 * m.b), 1e3 * radius);
  throw InputError(text);
}

}  // namespace

std::vector<Zone> Motor::zones(double speed) const { return zones(speed, model().r); }

std::vector<Zone> Motor::zones(double speed, double radius) const {
  const core::HeldTraps held;
  require_on_track(model(), radius);
  const auto [motor, point] = solved(speed);
  if (point.status != PointStatus::ok) return {};
  return core::zones_at(motor, speed, radius);
}

ContactFields Motor::fields(double speed, int samples) const {
  return fields(speed, samples, model().r);
}

ContactFields Motor::fields(double speed, int samples, double radius) const {
  const core::HeldTraps held;
  if (samples < 2)
    throw InputError("fields need at least 2 samples, not " + std::to_string(samples));
  require_on_track(model(), radius);
  const auto [motor, point] = solved(speed);
  ContactFields fields{core::operating_point_of(motor, point, speed, modes_.get()), radius, {}, {}};
  if (point.status != PointStatus::ok) return fields;
  fields.zones = core::zones_at(motor, speed, radius);
  fields.samples = core::fields_at(motor, speed, radius, samples);
  return fields;
}

BackwardWave Motor::backward_wave(double speed) const {
  const core::HeldTraps held;
  require_speed(model(), speed);
  const auto [motor, point] = solved(speed);
  return core::backward_wave_of(motor, point, speed, modes_.get(), design_.rotor.mass);
}

std::vector<WaveState> Motor::wave_states(double speed) const {
  const core::HeldTraps held;
  require_speed(model(), speed);
  std::vector<WaveState> states;
  if (!drive_) return states;
  for (const core::WaveSolution& s : drive()->solutions(speed)) {
    states.push_back({s.wave().amplitude, drive()->waves().phase_lag(s.wave()),
                      s.stability.determinant, s.stability.trace, s.stability.stable(),
                      s.running()});
  }
  return states;
}

std::vector<OperatingPoint> torque_speed_curve(const Motor& motor,
                                               const std::vector<double>& speeds) {
  std::vector<OperatingPoint> curve;
  curve.reserve(speeds.size());
  for (const double speed : speeds) curve.push_back(motor.operating_point(speed));
  return curve;
}

}  // namespace twum::inline v0_1
