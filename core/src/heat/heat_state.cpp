// SPDX-License-Identifier: Apache-2.0
#include "heat/heat_state.hpp"

#include "heat/heat_modes.hpp"

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::core {
namespace {

constexpr double kSettled =
    1e-5;  // a step of Newton's method; the next would be its square times the bend, 1e-13 K
constexpr double kNoStep = 1e-9;  // [K] of no account
constexpr int kMostSteps = 20;
constexpr double kFarApart = 5;       // [K] a steady state so far from the warm-up is another one
constexpr double kMarchError = 0.01;  // of a step of the warm-up [K]

bool is_finite(const Vector3& x) {
  return std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]);
}

Vector3 times(const std::array<Vector3, kSources>& slope, const Sources<double>& row) {
  Vector3 sum{};
  for (std::size_t k = 0; k < kSources; ++k) sum = plus(sum, row[k], slope[k]);
  return sum;
}

HeatState state_of(const NodeTemperatures& x, const WarmLosses& losses) {
  return {losses.status, x, losses.p, losses.slope, {}, 0, kIdentity3, {}, losses.wave};
}

// The eigenvalue farthest from zero.
double dominant(const Eigenvalues& e) {
  if (e.imaginary != 0 && std::hypot(e.real[1], e.imaginary) > std::fabs(e.real[0]))
    return e.real[1];
  if (e.imaginary != 0) return e.real[0];
  return *std::max_element(e.real.begin(), e.real.end(),
                           [](double a, double b) { return std::fabs(a) < std::fabs(b); });
}

}  // namespace

HeatSolver::HeatSolver(HeatProblem problem)
    : problem_(std::move(problem)),
      ambient_(problem_.ambient),
      fastest_(time_constants(problem_.network).front()),
      matrices_(matrices_of(problem_.network)),
      capacities_(capacities_of(problem_.network)) {
  for (std::size_t k = 0; k < kSources; ++k) {
    Sources<double> one{};
    one[k] = 1;
    const PartValues<double> parts = steady_parts(matrices_, one);
    for (std::size_t i = 0; i < kParts; ++i) response_[i][k] = parts[i];
  }
}

NodeTemperatures HeatSolver::image(const Sources<double>& p) const {
  NodeTemperatures x = ambient_nodes();
  for (std::size_t i = 0; i < 3; ++i) x[i] += dot(response_[kNodeParts[i]], p);
  return x;
}

Matrix3 HeatSolver::loop(const std::array<Vector3, kSources>& slope) const {
  Matrix3 phi;
  for (std::size_t i = 0; i < 3; ++i) phi[i] = times(slope, response_[kNodeParts[i]]);
  return phi;
}

Vector3 HeatSolver::newton_step(const HeatState& at) const {
  const Vector3 residual = plus(image(at.p), -1, at.x);
  return inverse(plus(kIdentity3, -1, loop(at.slope))) * residual;  // (H3.3)
}

HeatState HeatSolver::with_losses(const NodeTemperatures& x) const {
  return state_of(x, problem_.losses(x));
}

HeatState HeatSolver::with_losses_after(const NodeTemperatures& x, const HeatState* known) const {
  if (known && known->wave)
    if (const auto losses = problem_.followed(x, *known->wave)) return state_of(x, *losses);
  return with_losses(x);
}

// x and p move on by the step, p along its derivatives.
HeatState HeatSolver::newton(NodeTemperatures x, const HeatState* known) const {
  HeatState state;
  for (int i = 0; i < kMostSteps; ++i) {
    state = with_losses_after(x, known);
    if (state.status != MetricStatus::ok) return state;
    const Vector3 step = newton_step(state);
    if (!is_finite(step)) break;
    if (largest(step) <= kNoStep) return state;
    x = plus(x, 1, step);
    if (known) known = &state;
    if (largest(step) > kSettled) continue;
    state.x = x;
    for (std::size_t k = 0; k < kSources; ++k) state.p[k] += dot(state.slope[k], step);
    return state;
  }
  state.status = MetricStatus::no_steady_temperature;
  return state;
}

SteadyState HeatSolver::near(const NodeTemperatures& start) const {
  const HeatState found = newton(start, nullptr);
  return found.status == MetricStatus::ok ? judged(found) : SteadyState{found, 0, 0, 0};
}

// theta = K^-1 B p
SteadyState HeatSolver::judged(HeatState state) const {
  Vector3 heat;
  for (std::size_t i = 0; i < kMasses; ++i) heat[i] = dot(matrices_.B[i], state.p);
  state.theta = solved(matrices_.K, heat);
  const Matrix3 moves = jacobian(state);
  const double slowest = problem_.network.one_node ? moves[0][0] : abscissa(eigenvalues(moves));
  SteadyState steady{state, dominant(eigenvalues(loop(state.slope))), slowest, 0};
  if (steady.slowest >= 0) steady.state.status = MetricStatus::thermally_unstable;
  return steady;
}

SteadyState HeatSolver::from_cold() const {
  const HeatState cold = with_losses(ambient_nodes());
  if (cold.status != MetricStatus::ok) return {cold, 0, 0, 0};
  const NodeTemperatures first = plus(cold.x, 1, newton_step(cold));
  const HeatState guess = cold.wave ? newton(first, &cold) : HeatState{MetricStatus::undefined};
  // The wave that was followed is that of the motor if a search confirms it.
  const SteadyState found = near(guess.status == MetricStatus::ok ? guess.x : first);
  if (found.ok() && leads_there(cold, found)) return found;
  return marched();
}

// Whether the residual Phi(x) - x falls smoothly from cold to the steady state, so that there is no other one between: cubic
// Hermite interpolation along the way tells its value in the middle, unless both ends have nearly the same slope.
bool HeatSolver::leads_there(const HeatState& cold, const SteadyState& found) const {
  constexpr double kMostGain = 0.5, kBend = 0.1;
  const Vector3 way = plus(found.state.x, -1, cold.x);
  const double square = dot(way, way);
  const auto along = [&](const Vector3& v) { return dot(way, v) / square; };
  const auto gain = [&](const HeatState& at) { return along(loop(at.slope) * way); };
  const double first = along(plus(image(cold.p), -1, cold.x));
  const double slope_cold = gain(cold) - 1, slope_end = gain(found.state) - 1;
  if (!(first > 0) || gain(cold) > kMostGain || gain(found.state) > kMostGain) return false;
  if (std::fabs(slope_cold - slope_end) <= kBend * first) return true;
  const HeatState middle = with_losses(plus(cold.x, 0.5, way));
  if (middle.status != MetricStatus::ok || gain(middle) > kMostGain) return false;
  const double expected = first / 2 + (slope_cold - slope_end) / 8;
  const double there = along(plus(image(middle.p), -1, middle.x));
  return std::fabs(there - expected) <= kBend * first;
}

Matrix3 HeatSolver::settling(const HeatState& s) const {
  Matrix3 spread;
  for (std::size_t i = 0; i < 3; ++i) spread[i] = times(s.slope, matrices_.D[kNodeParts[i]]);
  return inverse(plus(kIdentity3, -1, spread));
}

Matrix3 HeatSolver::jacobian(const HeatState& s) const {
  // p_theta = (I - p_x D)^-1 p_x M = p_x (I - D p_x)^-1 M
  Matrix3 masses;
  for (std::size_t i = 0; i < 3; ++i) masses[i] = matrices_.M[kNodeParts[i]];
  const Matrix3 nodes = settling(s) * masses;  // dx / dtheta
  Matrix3 j;
  for (std::size_t i = 0; i < kMasses; ++i) {
    const Vector3 heat = times(s.slope, matrices_.B[i]);  // by x
    for (std::size_t c = 0; c < kMasses; ++c) {
      double sum = -matrices_.K[i][c];
      for (std::size_t k = 0; k < 3; ++k) sum += heat[k] * nodes[k][c];
      j[i][c] = sum / capacities_[i];
    }
  }
  if (problem_.network.one_node) j[1] = {0, j[0][0], 0}, j[2] = {0, 0, j[0][0]};  // no masses
  return j;
}

Vector3 HeatSolver::rate(const HeatState& s) const {
  const Vector3 loss = matrices_.K * s.theta;
  Vector3 rate;
  for (std::size_t i = 0; i < kMasses; ++i)
    rate[i] = (dot(matrices_.B[i], s.p) - loss[i]) / capacities_[i];
  return rate;
}

// Solves x = T_a + M theta + D p for x, with p linear about what is known.
NodeTemperatures HeatSolver::nodes_at(const Vector3& theta, const HeatState& known) const {
  Matrix3 spread;
  Vector3 off;
  for (std::size_t k = 0; k < 3; ++k) {
    spread[k] = times(known.slope, matrices_.D[kNodeParts[k]]);
    off[k] = ambient_ + dot(matrices_.M[kNodeParts[k]], theta) +
             dot(matrices_.D[kNodeParts[k]], known.p) - known.x[k];
  }
  return plus(known.x, 1, inverse(plus(kIdentity3, -1, spread)) * off);
}

HeatState HeatSolver::at_masses(const Vector3& theta, NodeTemperatures guess,
                                const HeatState* near) const {
  constexpr double kNear =
      0.02;  // [K]; what a linear step leaves is its square times the bend, 1e-6 K
  constexpr int kMostTries = 8;
  HeatState state;
  for (int i = 0; i < kMostTries; ++i) {
    state = with_losses_after(guess, i == 0 ? near : &state);
    state.theta = theta;
    if (state.status != MetricStatus::ok) return state;
    const NodeTemperatures x = nodes_at(theta, state);
    const Vector3 step = plus(x, -1, guess);
    if (!is_finite(step)) break;
    guess = x;
    if (largest(step) > kNear) continue;
    state.x = x;
    for (std::size_t k = 0; k < kSources; ++k) state.p[k] += dot(state.slope[k], step);
    return state;
  }
  state.status = MetricStatus::no_steady_temperature;
  return state;
}

// theta + dt phi(dt J) theta' (H4.3)
HeatSolver::Flow HeatSolver::flow(const HeatState& s, double time) const {
  const Exponential e = exponential(plus(Matrix3{}, time, jacobian(s)));
  return {plus(s.theta, time, e.phi * rate(s)), e.exp};
}

HeatSolver::Linear HeatSolver::with_cold_losses(double time) const {
  HeatState state = with_losses(ambient_nodes());
  state.slope = {};
  const Flow free = flow(state, time);
  return {free.exp, free.theta};
}

// Two half steps and a whole one: their difference tells the error, and a third of it improves the end.
HeatSolver::Step HeatSolver::step(const HeatState& s, double time) const {
  const Vector3 whole = flow(s, time).theta;
  const Flow first = flow(s, time / 2);
  const HeatState middle = at_masses(first.theta, nodes_at(first.theta, s), &s);
  if (middle.status != MetricStatus::ok) return {middle, HUGE_VAL};
  const Flow second = flow(middle, time / 2);
  const Vector3 difference = plus(second.theta, -1, whole);
  const Vector3 better = plus(second.theta, 1.0 / 3, difference);
  HeatState end = at_masses(better, nodes_at(better, middle), &middle);
  end.time = s.time + time;
  end.moved = second.exp * (first.exp * s.moved);
  for (std::size_t k = 0; k < kSources; ++k)  // Simpson's rule
    end.heat[k] = s.heat[k] + time / 6 * (s.p[k] + 4 * middle.p[k] + end.p[k]);
  return {end, largest(difference)};
}

// Shortens the step until its error is small, or the point is lost within a hundredth of the fastest time constant.
HeatSolver::Advance HeatSolver::one_step(const HeatState& s, double wanted,
                                         double tolerance) const {
  const double shortest = 1e-2 * fastest_;
  for (double time = wanted;;) {
    const Step tried = step(s, time);
    const bool lost = tried.end.status != MetricStatus::ok;
    const double scale =
        lost ? 0.25
             : std::clamp(0.9 * std::cbrt(tolerance / std::max(tried.error, 1e-300)), 0.2, 4.0);
    if (!lost && tried.error <= tolerance) return {tried.end, time, time * scale};
    if (time <= shortest) {
      HeatState end = tried.end;
      if (lost && end.status != MetricStatus::temperature_out_of_range)
        end.status = MetricStatus::no_steady_temperature;
      end.time = s.time;
      return {end, time, time};
    }
    time = std::max(shortest, time * scale);
  }
}

std::vector<HeatState> HeatSolver::marched_to(const HeatState& start, double duration,
                                              double tolerance, double longest) const {
  std::vector<HeatState> states{start};
  states.front().moved = kIdentity3, states.front().heat = {};
  const double end = start.time + duration;
  double next = std::min(longest, fastest_);
  while (states.back().status == MetricStatus::ok && states.back().time < end) {
    const double left = end - states.back().time;
    const double wanted = std::min(next, std::max(longest, (states.back().time - start.time) / 2));
    const Advance done =
        one_step(states.back(), wanted >= left ? left : std::min(wanted, left / 2), tolerance);
    states.push_back(done.state), next = done.next;
    if (left - done.time <= 1e-12 * duration) states.back().time = end;
  }
  return states;
}

HeatSolver::Way::Way(const HeatSolver& solver, const HeatState& start, double tolerance)
    : states_{start}, tolerance_(tolerance), next_(solver.fastest_ / 2) {
  lost_ = start.status != MetricStatus::ok;
}

// As marched_to(), but for its last steps.
void HeatSolver::Way::go_on(const HeatSolver& solver, double until) {
  while (!lost_ && states_.back().time < until) {
    const double longest =
        std::max(solver.fastest_ / 2, (states_.back().time - states_.front().time) / 2);
    const Advance done = solver.one_step(states_.back(), std::min(next_, longest), tolerance_);
    lost_ = done.state.status != MetricStatus::ok;
    if (!lost_) states_.push_back(done.state), next_ = done.next;
  }
}

std::vector<HeatState> HeatSolver::followed(const HeatState& start, double duration,
                                            double tolerance) const {
  std::vector<HeatState> way = marched_to(start, duration, tolerance, fastest_ / 2);
  const auto last = std::find_if(way.rbegin(), way.rend(), [](const HeatState& state) {
    return state.status == MetricStatus::ok;
  });
  if (last == way.rend() || is_confirmed(*last)) return way;
  return searching().marched_to(start, duration, tolerance, fastest_ / 2);
}

HeatSolver HeatSolver::searching() const {
  HeatSolver other = *this;
  other.problem_.followed = {};
  return other;
}

// The wave of a state is that a little before its temperatures; another wave is far from it.
bool HeatSolver::is_confirmed(const HeatState& state) const {
  constexpr double kSame = 1e-2;
  if (!problem_.followed || !state.wave) return true;
  const WarmLosses found = problem_.losses(state.x);
  return found.wave && std::fabs(found.wave->amplitude / state.wave->amplitude - 1) <= kSame &&
         std::fabs(found.wave->speed / state.wave->speed - 1) <= kSame;
}

HeatState HeatSolver::advanced(const HeatState& start, double duration, double tolerance) const {
  return marched_to(start, duration, tolerance, duration).back();
}

// After each step Newton's method may end the march, at a stable state close by.
SteadyState HeatSolver::marched() const {
  constexpr double kLongest = 300;  // slow time constants; a passage past a fold takes some twenty
  const std::vector<double> tau = time_constants(problem_.network);
  HeatState state = cold();
  double next = tau.front();
  while (state.status == MetricStatus::ok && state.time < kLongest * tau.back()) {
    const Advance done = one_step(state, next, kMarchError);
    state = done.state, next = done.next;
    if (state.status != MetricStatus::ok) break;
    if (largest(newton_step(state)) > kFarApart) continue;
    const SteadyState found = near(state.x);
    if (found.ok() && largest(plus(found.state.x, -1, state.x)) <= kFarApart) return found;
  }
  SteadyState none{state, 0, 0, state.time};
  if (state.status == MetricStatus::ok) none.state.status = MetricStatus::thermally_unstable;
  return none;
}

PartValues<double> HeatSolver::part_rates(const HeatState& s) const {
  const Vector3 masses = rate(s);
  Vector3 nodes;
  for (std::size_t i = 0; i < 3; ++i) nodes[i] = dot(matrices_.M[kNodeParts[i]], masses);
  nodes = settling(s) * nodes;
  PartValues<double> rates{masses[0], masses[1], masses[2], 0, 0};
  if (problem_.network.one_node) rates[1] = rates[2] = masses[0];
  for (std::size_t i = 0; i < 3; ++i) rates[kNodeParts[i]] = nodes[i];
  return rates;
}

PartValues<double> HeatSolver::parts(const HeatState& s) const {
  PartValues<double> t = parts_at(matrices_, s.theta, s.p);
  for (double& one : t) one += ambient_;
  return t;
}

}  // namespace twum::inline v0_1::core
