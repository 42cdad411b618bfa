// SPDX-License-Identifier: Apache-2.0
#include "steady.hpp"

#include <twum/base/error.hpp>
#include <twum/core/metrics.hpp>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <string>

namespace twum::inline v0_1::motion {
namespace {

[[noreturn]] void refuse(const std::string& why) {
  throw InputError("there is no steady running state at the first values of drive and load: " +
                   why);
}

// The design under the drive at the beginning of a stretch.
MotorDesign with_drive(const MotorDesign& design, const Stretch& s) {
  const Parameter drive = design.stator.voltage ? Parameter::voltage : Parameter::amplitude;
  const Ramp& value = design.stator.voltage ? s.voltage : s.amplitude;
  const ParameterValue values[] = {{drive, value.value}, {Parameter::frequency, s.frequency.value}};
  return with(design, values);
}

// The state on the motor's curve that carries a torque without viscous friction.
States state_on_curve(const MotorDesign& design, const Equations& equations, double torque) {
  const Motor motor(with_drive(design, equations.stretch()));
  const MetricValue speed = evaluate(motor, {Metric::speed_at, Argument::torque, torque});
  if (speed.status != MetricStatus::ok) refuse(to_string(speed.status));
  const OperatingPoint point = motor.operating_point(speed.value);
  if (point.status != PointStatus::ok) refuse(to_string(point.status));
  States y{};
  y[kSpeed] = speed.value;
  if (!equations.model().driven) return y;
  const Complex zeta = std::polar(point.amplitude, -point.phase_lag);
  y[kReal] = zeta.real(), y[kImaginary] = zeta.imag();
  const auto [voltage, current, source] = equations.settled_circuit(equations.stretch().begin, y);
  equations.set_circuit(y, voltage, current);
  return y;
}

// The states that are steady: the angle and the energy go on.
std::vector<std::size_t> steady_states(const Equations& equations) {
  const StatePlaces& places = equations.places();
  std::vector<std::size_t> in{kSpeed};
  if (equations.model().driven) in = {kReal, kImaginary, kSpeed};
  for (const std::size_t pair : {places.voltage, places.current, places.height})
    if (pair != StatePlaces::kNone) in.insert(in.end(), {pair, pair + 1});
  return in;
}

// The size of a state, of which its last step may be a share.
double size_of(std::size_t place, const Equations& equations, const States& y) {
  const StatePlaces& places = equations.places();
  const auto pair = [&](std::size_t begin) { return std::hypot(y[begin], y[begin + 1]); };
  if (place == kSpeed) return y[kSpeed];
  for (const std::size_t begin : {places.voltage, places.current})
    if (begin != StatePlaces::kNone && (place == begin || place == begin + 1)) return pair(begin);
  const double amplitude = equations.amplitude(equations.stretch().begin, y);
  if (places.height == StatePlaces::kNone || place != places.rise) return amplitude;
  return amplitude * 2 * std::numbers::pi * equations.stretch().frequency.value;
}

Eigen::MatrixXd jacobian_of(Equations& equations, const States& y,
                            const std::vector<std::size_t>& in) {
  const std::size_t count = equations.places().count;
  std::vector<double> slopes(count * count);
  if (!equations.jacobian(equations.stretch().begin, y, slopes))
    refuse(equations.contact().failure());
  const auto n = static_cast<Eigen::Index>(in.size());
  Eigen::MatrixXd jacobian(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
      jacobian(i, j) =
          slopes[in[static_cast<std::size_t>(j)] * count + in[static_cast<std::size_t>(i)]];
  return jacobian;
}

using Solver = Eigen::FullPivLU<Eigen::MatrixXd>;

// States in SI units differ by so much that a pivot may be small and count: none is taken as zero.
Solver solver_of(Equations& equations, const States& y, const std::vector<std::size_t>& in) {
  Solver solver(jacobian_of(equations, y, in));
  solver.setThreshold(std::numeric_limits<double>::min());
  return solver;
}

// Newton's step from a state: the solution of J dy = -y' in the states that count.
Eigen::VectorXd newton_step(Equations& equations, const States& y,
                            const std::vector<std::size_t>& in) {
  States rates{};
  if (!equations.rates(equations.stretch().begin, y, rates)) refuse(equations.contact().failure());
  Eigen::VectorXd residual(static_cast<Eigen::Index>(in.size()));
  for (std::size_t i = 0; i < in.size(); ++i)
    residual[static_cast<Eigen::Index>(i)] = -rates[in[i]];
  return solver_of(equations, y, in).solve(residual);
}

States newton_solution(Equations& equations, States y) {
  const std::vector<std::size_t> in = steady_states(equations);
  for (int iteration = 0; iteration < 30; ++iteration) {
    const Eigen::VectorXd step = newton_step(equations, y, in);
    double largest = 0;
    for (std::size_t i = 0; i < in.size(); ++i) {
      const double d = step[static_cast<Eigen::Index>(i)];
      y[in[i]] += d;
      largest = std::max(largest, std::abs(d / size_of(in[i], equations, y)));
    }
    if (!(y[kSpeed] > 0)) break;
    if (largest < 1e-11) return y;  // quadratic: the next step would be rounding
  }
  refuse("friction and load do not let it run");
}

}  // namespace

States steady_state(const MotorDesign& design, Equations& equations) {
  if (equations.model().stiffness > 0) refuse("the load has a spring");
  equations.set_mode({false, 1});
  const Stretch asked = equations.stretch();
  const double torque = asked.load_torque.value, friction = equations.model().load_friction;
  // The curve ends at no-load. From there a load that drives the rotor is approached in steps of 5 % of the holding torque.
  States y = state_on_curve(design, equations, std::max(torque + friction, 0.0));
  if (equations.places().height != StatePlaces::kNone)
    y[equations.places().height] =
        equations.model().balanced_height(equations.amplitude(asked.begin, y));
  const double driving = std::min(torque + friction, 0.0);
  const int steps = 1 + static_cast<int>(-driving / (0.05 * equations.model().holding_torque));
  Stretch nearer = asked;
  for (int step = 1; step <= steps; ++step) {
    nearer.load_torque.value = torque - driving * (steps - step) / steps;
    equations.set_stretch(nearer);
    y = newton_solution(equations, y);
  }
  equations.set_stretch(asked);
  return y;
}

std::vector<double> steady_slopes(Equations& equations, const States& y, std::size_t columns) {
  const std::size_t count = equations.places().count;
  std::vector<double> slopes(columns * count);
  if (!equations.parameter_slopes(equations.stretch().begin, y, slopes))
    refuse(equations.contact().failure());
  const std::vector<std::size_t> in = steady_states(equations);
  const Solver solver = solver_of(equations, y, in);
  for (std::size_t k = 0; k < columns; ++k) {
    const std::span<double> column = std::span(slopes).subspan(k * count, count);
    Eigen::VectorXd right(static_cast<Eigen::Index>(in.size()));
    for (std::size_t i = 0; i < in.size(); ++i)
      right[static_cast<Eigen::Index>(i)] = -column[in[i]];
    const Eigen::VectorXd moved = solver.solve(right);
    std::ranges::fill(column, 0.0);
    for (std::size_t i = 0; i < in.size(); ++i) column[in[i]] = moved[static_cast<Eigen::Index>(i)];
  }
  return slopes;
}

}  // namespace twum::inline v0_1::motion
