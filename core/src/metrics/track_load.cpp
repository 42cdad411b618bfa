// SPDX-License-Identifier: Apache-2.0
#include "metrics/track_load.hpp"

#include "curve/curve.hpp"
#include "metrics/found_value.hpp"
#include "point/slice_count.hpp"

#include <twum/core/metrics.hpp>

#include <cmath>
#include <utility>

namespace twum::inline v0_1::core {
namespace {

using M = Metric;

DrivenMotor<double> motor_with_given_wave(const MotorDesign& design) {
  const ModelArray<double> values = model_values(design);
  return driven(motor_model(values, track_rule(design)), design_wave(values));
}

// T(Omega) = T_L by Newton's method from the speed nearby. Nothing where it does not settle.
std::optional<SolvedLoad> near_speed(const MotorDesign& design, double torque, double speed) {
  constexpr int kMostSteps = 12;
  constexpr double kSettled = 1e-13;  // of the crest's speed; what a step leaves is of its square
  DrivenMotor<double> m = motor_with_given_wave(design);
  const double unit = m.mean.crest_velocity / m.r;
  double last = 0.2 * unit;
  for (int i = 0; i < kMostSteps; ++i) {
    SolvedPoint point = solve_point(m, speed);
    if (point.status != PointStatus::ok) return {};
    const auto moving = point.differentiated(
        m, contact::MotionDual::variable(speed, contact::kInSpeed), contact::Means::of_wave);
    const double slope = moving.torque.d[contact::kInSpeed];
    const double step = (torque - moving.torque.v) / slope;
    if (!(slope < 0) || !(std::fabs(step) <= last)) return {};
    if (std::fabs(step) <= kSettled * unit)
      return SolvedLoad{std::move(m), std::move(point), speed};
    last = std::fmax(std::fabs(step), 1e-11 * unit);  // then rounding may keep steps from shrinking
    speed += step;
  }
  return {};
}

// Speed and wave of a load, from a search of its own.
LoadWave searched(const MotorDesign& design, const LoadPoint& load) {
  const Motor motor(design);
  LoadWave wave{design.stator.amplitude, load.at};
  if (load.argument == Argument::torque)
    wave.speed = known(evaluate(motor, {M::speed_at, load.argument, load.at}));
  if (design.stator.voltage)
    wave.amplitude = known(evaluate(motor, {M::amplitude_at, load.argument, load.at}));
  return wave;
}

std::optional<SolvedLoad> solved_near(const MotorDesign& design, const LoadPoint& load,
                                      const LoadWave& near) {
  if (design.stator.voltage) {
    const auto curve = FollowedCurve::from(design, load, near);
    if (!curve) return {};
    return SolvedLoad{curve->found().motor, curve->found().solved, curve->speed()};
  }
  if (load.argument == Argument::torque) return near_speed(design, load.at, near.speed);
  DrivenMotor<double> m = motor_with_given_wave(design);
  SolvedPoint point = solve_point(m, load.at);
  if (point.status != PointStatus::ok) return {};
  return SolvedLoad{std::move(m), std::move(point), load.at};
}

}  // namespace

SolvedLoad solved_load(const MotorDesign& worn, const LoadPoint& load,
                       const std::optional<LoadWave>& near) {
  if (near)
    if (auto found = solved_near(worn, load, *near)) return *std::move(found);
  auto found = solved_near(worn, load, searched(worn, load));
  if (!found) throw SearchFailure{MetricStatus::unresolved};
  return *std::move(found);
}

}  // namespace twum::inline v0_1::core
