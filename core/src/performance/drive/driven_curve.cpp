// SPDX-License-Identifier: Apache-2.0
#include "performance/drive/driven_curve.hpp"

#include "performance/curve/prescribed_curve.hpp"

namespace twum::performance {
namespace {

using contact::SpeedDual;

template <typename S>
S input_power(Input input, const StatorModes<S>& modes, const PointNumbers<S>& n,
              const S& amplitude, const S& omega) {
  const S velocity = omega * amplitude;
  if (input == Input::mechanical) return n.stator_power + modes.damping * velocity * velocity;
  const WaveBalance<S> w = wave_balance(modes, amplitude, omega, n.reactive_force, n.stator_power);
  return terminals(modes, w, amplitude, omega).power;
}

SpeedDual combined(const SpeedDual& in_speed, const SpeedDual& in_amplitude, double rate) {
  SpeedDual x = in_speed;
  x.d[0] += rate * in_amplitude.d[0];
  return x;
}

CurvePoint curve_point(double speed, const DrivenMotor<double>& motor, const SolvedPoint& solved,
                       Input input, const StatorModes<double>& modes) {
  CurvePoint p;
  p.speed = speed;
  p.status = metric_status(solved.status);
  if (!p.ok()) {
    p.lost = solved.zones_followed();
    return p;
  }
  p.torque = solved.numbers.torque;
  p.input = input_power(input, modes, solved.numbers, motor.amplitude, motor.omega);
  p.plateau = solved.drives();
  p.special = solved.special;
  p.signature = solved.signature();
  p.start = solved.start();
  return p;
}

}  // namespace

CurvePoint DrivenCurve::point(double speed, const WarmStart*, double) const {
  const MotorPoint at = drive_.at(speed);
  return curve_point(speed, at.motor, at.solved, input_, drive_.waves().modes());
}

CurvePoint TerminalCurve::point(double speed, const WarmStart* guess, double accuracy) const {
  return curve_point(speed, motor(), solve_point(motor(), speed, guess, accuracy),
                     Input::electrical, modes_);
}

CurveSlope TerminalCurve::slope(double speed, const WarmStart* guess) const {
  const SolvedPoint solved = solve_point(motor(), speed, guess);
  if (solved.status != PointStatus::ok) throw SearchFailure{metric_status(solved.status)};
  const PointNumbers<SpeedDual> n = solved.differentiated(motor(), SpeedDual::variable(speed, 0));
  const SpeedDual input = input_power(Input::electrical, constant_modes<SpeedDual>(modes_), n,
                                      SpeedDual(motor().amplitude), SpeedDual(motor().omega));
  return {speed, {n.torque.v, n.torque.d[0]}, {input.v, input.d[0]}, solved.start()};
}

// Total derivatives: the amplitude moves along the level curve H(A, Omega) = Theta u_0 (D2.9).
CurveSlope DrivenCurve::slope(double speed, const WarmStart*) const {
  const MotorPoint at = drive_.at(speed);
  if (at.solved.status != PointStatus::ok) throw SearchFailure{metric_status(at.solved.status)};
  const DrivenWaves& waves = drive_.waves();
  const double a = at.motor.amplitude;
  const PointNumbers<SpeedDual> in_speed = waves.along(at.solved, a, speed, 0, 1),
                                in_amplitude = waves.along(at.solved, a, speed, 1, 0);
  const StatorModes<SpeedDual> modes = constant_modes<SpeedDual>(waves.modes());
  const SpeedDual omega(at.motor.omega), fixed(a), moving = SpeedDual::variable(a, 0);
  const auto force_slope = [&](const PointNumbers<SpeedDual>& n, const SpeedDual& amplitude) {
    return wave_balance(modes, amplitude, omega, n.reactive_force, n.stator_power).force().d[0];
  };
  const double rate = -force_slope(in_speed, fixed) / force_slope(in_amplitude, moving);
  const SpeedDual torque = combined(in_speed.torque, in_amplitude.torque, rate);
  const SpeedDual input = combined(input_power(input_, modes, in_speed, fixed, omega),
                                   input_power(input_, modes, in_amplitude, moving, omega), rate);
  return {speed, {torque.v, torque.d[0]}, {input.v, input.d[0]}, at.solved.start()};
}

}  // namespace twum::performance
