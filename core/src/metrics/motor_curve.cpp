// SPDX-License-Identifier: Apache-2.0
#include "metrics/motor_curve.hpp"

#include <limits>

namespace twum::inline v0_1::core {
namespace {

using contact::kInAmplitude;
using contact::kInSpeed;
using contact::MotionDual;

// P_el of a wave (D4.3).
template <typename S>
S electrical_power(const StatorModes<S>& modes, const PointNumbers<S>& n, const S& amplitude,
                   const S& omega) {
  const WaveBalance<S> force =
      wave_balance(modes, amplitude, omega, n.reactive_force, n.stator_power);
  return terminals(modes, force, amplitude, omega).power;
}

// @param modes  null if they are not known: then the power at the terminals is not either
CurvePoint curve_point(double speed, const DrivenMotor<double>& m, const SolvedPoint& solved,
                       const StatorModes<double>* modes) {
  if (solved.status != PointStatus::ok)
    return {
        .speed = speed, .status = metric_status(solved.status), .lost = solved.zones_followed()};
  const PointNumbers<double>& n = solved.numbers;
  return {.speed = speed,
          .torque = n.torque,
          .input = n.stator_power + stator_loss(m),
          .electrical_input = modes ? electrical_power(*modes, n, m.mean.amplitude, m.omega)
                                    : std::numeric_limits<double>::quiet_NaN(),
          .plateau = solved.drives(),
          .special = solved.special,
          .signature = solved.signature(),
          .start = solved.start()};
}

void require_answer(const SolvedPoint& solved) {
  if (solved.status != PointStatus::ok) throw SearchFailure{metric_status(solved.status)};
}

}  // namespace

MetricStatus metric_status(PointStatus status) {
  switch (status) {
    case PointStatus::ok: return MetricStatus::ok;
    case PointStatus::no_periodic_state: return MetricStatus::no_periodic_state;
    case PointStatus::not_converged: return MetricStatus::not_converged;
    case PointStatus::resonance: return MetricStatus::resonance;
    case PointStatus::unresolved: return MetricStatus::unresolved;
    case PointStatus::inaccurate: return MetricStatus::inaccurate;
    case PointStatus::pulled_out: return MetricStatus::pulled_out;
    case PointStatus::no_running_branch: return MetricStatus::no_running_branch;
    case PointStatus::no_dead_branch: return MetricStatus::no_dead_branch;
    case PointStatus::unstable_amplitude: return MetricStatus::unstable_amplitude;
  }
  return MetricStatus::unresolved;
}

CurvePoint PrescribedCurve::point(double speed, const WarmStart* guess, double accuracy) const {
  return curve_point(speed, motor(), solve_point(motor(), speed, guess, accuracy), modes_);
}

CurveSlope PrescribedCurve::slope(double speed, const WarmStart* guess) const {
  const DrivenMotor<double>& m = motor();
  const SolvedPoint solved = solve_point(m, speed, guess);
  require_answer(solved);
  const PointNumbers<MotionDual> n =
      solved.differentiated(m, MotionDual::variable(speed, kInSpeed), contact::Means::of_wave);
  const auto sloped = [](const MotionDual& x) { return Sloped{x.v, x.d[kInSpeed]}; };
  CurveSlope s{
      speed, sloped(n.torque), sloped(n.stator_power + stator_loss(m)), {}, solved.start()};
  if (modes_)
    s.electrical_input = sloped(electrical_power(
        constant_modes<MotionDual>(*modes_), n, MotionDual(m.mean.amplitude), MotionDual(m.omega)));
  return s;
}

CurvePoint DrivenCurve::point(double speed, const WarmStart*, double) const {
  const MotorPoint at = drive_.at(speed);
  return curve_point(speed, at.motor, at.solved, &drive_.waves().modes());
}

Vector<CurvePoint> DrivenCurve::known_points() const {
  Vector<CurvePoint> points;
  if (may_jump() || !drive_.runs()) return points;
  const DrivenWaves& waves = drive_.waves();
  for (const CurveNode* node : drive_.branch().nodes())
    if (!node->grows)
      points.push_back(
          curve_point(node->parameter, waves.motor(node->amplitude), node->solved, &waves.modes()));
  return points;
}

// Total derivatives: the amplitude moves along the level curve H(A, Omega) = Theta u_0 (D2.9).
CurveSlope DrivenCurve::slope(double speed, const WarmStart*) const {
  const MotorPoint at = drive_.at(speed);
  require_answer(at.solved);
  const DrivenWaves& waves = drive_.waves();
  const DrivenWaves::MovingWave wave = waves.moving(at.solved, at.motor.mean.amplitude, speed);
  const PointNumbers<MotionDual>& n = wave.numbers;
  const MotionDual omega(at.motor.omega), velocity = omega * wave.amplitude;
  const double rate = wave.amplitude_per_speed();
  const auto along = [&](const MotionDual& x) {
    return Sloped{x.v, x.d[kInSpeed] + rate * x.d[kInAmplitude]};
  };
  return {
      speed, along(n.torque), along(n.stator_power + at.motor.stator_damping * velocity * velocity),
      along(electrical_power(constant_modes<MotionDual>(waves.modes()), n, wave.amplitude, omega)),
      at.solved.start()};
}

// Under a wave that it has at some voltage.
DrivenMotor<double> RestCurve::any_of(const WavesAtRest& waves) {
  if (waves.largest()) return waves.waves().motor(waves.largest()->amplitude);
  return waves.waves().motor(waves.extrema().empty() ? 0 : waves.extrema().front().amplitude);
}

CurvePoint RestCurve::point(double, const WarmStart*, double) const {
  throw SearchFailure{MetricStatus::unresolved};
}

CurveSlope RestCurve::slope(double, const WarmStart*) const {
  throw SearchFailure{MetricStatus::unresolved};
}

}  // namespace twum::inline v0_1::core
