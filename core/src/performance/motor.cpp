// SPDX-License-Identifier: Apache-2.0
#include <twum/core/performance/motor.hpp>

#include "performance/fields.hpp"
#include "performance/point.hpp"

#include <twum/base/error.hpp>

#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <string>

namespace twum {
namespace {

std::string speed_text(double speed) {
  char text[64];
  std::snprintf(text, sizeof text, "%.6g rad/s (%.6g rpm)", speed, speed * 30 / std::numbers::pi);
  return text;
}

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

OperatingPoint no_answer(double speed, PointStatus status) {
  return {speed,    kNoValue, kNoValue, kNoValue, kNoValue,
          kNoValue, kNoValue, kNoValue, kNoValue, status};
}

}  // namespace

const char* to_string(PointStatus status) noexcept {
  switch (status) {
    case PointStatus::ok: return "ok";
    case PointStatus::no_periodic_state: return "no-periodic-state";
    case PointStatus::not_converged: return "not-converged";
    case PointStatus::resonance: return "resonance";
    case PointStatus::unresolved: return "unresolved";
    case PointStatus::inaccurate: return "inaccurate";
  }
  return "unresolved";
}

const char* to_string(ZoneState state) noexcept {
  return state == ZoneState::stick ? "stick" : state == ZoneState::slip_plus ? "slip+" : "slip-";
}

double OperatingPoint::contact_efficiency() const noexcept {
  const double excess = stator_power - output_power - friction_power - layer_loss;
  return performance::is_known(stator_power, excess) ? output_power / stator_power : kNoValue;
}

double OperatingPoint::efficiency() const noexcept {
  const double input = stator_power + stator_loss;
  const double excess = stator_power - output_power - friction_power - layer_loss;
  return performance::is_known(input, excess) ? output_power / input : kNoValue;
}

Motor::Motor(const MotorDesign& design) : design_(design) {
  const std::vector<std::string> wrong = complaints(design);
  if (!wrong.empty()) {
    std::string text = "motor design: " + wrong.front();
    for (std::size_t i = 1; i < wrong.size(); ++i) text += "; " + wrong[i];
    throw InputError(text);
  }
  model_ = std::make_shared<const performance::MotorModel<double>>(
      performance::motor_model<double>(design, performance::parameter_values(design)));
}

const NormalContact<double>& Motor::contact() const noexcept { return model_->contact; }

double Motor::crest_speed() const noexcept { return model_->crest_velocity / model_->r; }

double Motor::wave_speed() const noexcept { return model_->omega / model_->kappa / model_->r; }

double Motor::holding_torque() const noexcept {
  return model_->static_ * model_->preload * model_->r;
}

bool Motor::locks_at_rest() const noexcept { return performance::locks_at_rest(*model_); }

void Motor::require_speed(double speed) const {
  if (!performance::wave_meets_rotor(*model_, speed)) {
    throw InputError("rotor speed must be more than the wave's backward speed, " +
                     speed_text(-wave_speed()) + ", but is " + speed_text(speed));
  }
}

OperatingPoint Motor::operating_point(double speed) const {
  require_speed(speed);
  const performance::MotorModel<double>& m = *model_;
  const performance::SolvedPoint solved = performance::solve_point(m, speed);
  if (solved.status != PointStatus::ok) return no_answer(speed, solved.status);
  const performance::PointNumbers<double>& n = solved.numbers;
  const double velocity = m.omega * m.amplitude;
  return {speed,
          n.torque,
          n.torque * speed,
          n.stator_power,
          n.friction_power,
          n.layer_loss,
          m.stator_damping * velocity * velocity,
          n.friction_power / (2 * std::numbers::pi * m.r * m.b),
          n.stick_fraction,
          PointStatus::ok};
}

std::vector<Zone> Motor::zones(double speed) const {
  require_speed(speed);
  return performance::zones(*model_, speed);
}

ContactFields Motor::fields(double speed, int samples) const {
  if (samples < 2)
    throw InputError("fields need at least 2 samples, not " + std::to_string(samples));
  return {operating_point(speed), zones(speed),
          performance::sample_fields(*model_, speed, samples)};
}

std::vector<OperatingPoint> torque_speed_curve(const Motor& motor,
                                               const std::vector<double>& speeds) {
  std::vector<OperatingPoint> curve;
  curve.reserve(speeds.size());
  for (const double speed : speeds) curve.push_back(motor.operating_point(speed));
  return curve;
}

}  // namespace twum
