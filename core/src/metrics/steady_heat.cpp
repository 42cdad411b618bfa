// SPDX-License-Identifier: Apache-2.0
#include <twum/core/steady_heat.hpp>

#include "curve/curve.hpp"
#include "design/held_traps.hpp"
#include "metrics/load_losses.hpp"

#include <twum/base/error.hpp>
#include <twum/core/plate.hpp>

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1 {

using namespace core;

namespace {

constexpr double kStepError = 1e-3;  // of a step in time [K]

HeatLosses losses_of(const Sources<double>& p) { return {p[0], p[1], p[2], p[3]}; }

void require_heat(const MotorDesign& design) {
  require_motor(design);
  if (!design.thermal) throw InputError("the motor needs 'thermal' for its temperatures");
}

// With the statuses of the network's own losses.
template <typename Answer, typename Ask>
Answer solved_by(const MotorDesign& design, const LoadPoint& load, Ask ask) {
  const HeldTraps traps;
  require_heat(design);
  MotorDesign kept = design;
  keep_plate(kept);
  return ask(HeatSolver(heat_problem(kept, network_of(kept), load)));
}

SteadyHeat answer_of(const HeatSolver& solver, const SteadyState& steady, bool any_stability) {
  const MetricStatus status = steady.state.status;
  const bool unstable = any_stability && status == MetricStatus::thermally_unstable;
  SteadyHeat heat{status, {}, {}, 0, 0, steady.lost_after};
  if (status != MetricStatus::ok && !unstable) return heat;
  heat.temperatures = parts_of(solver.parts(steady.state));
  heat.losses = losses_of(steady.state.p);
  heat.gain = steady.gain;
  heat.time_constant = -1 / steady.slowest;
  return heat;
}

}  // namespace

std::optional<HeatNetwork> motor_network(const MotorDesign& design) try {
  const HeldTraps traps;
  require_heat(design);
  return network_of(design);
} catch (const SearchFailure&) {
  return {};
}

SteadyHeat steady_heat(const MotorDesign& design, const LoadPoint& load) try {
  return solved_by<SteadyHeat>(design, load, [](const HeatSolver& solver) {
    return answer_of(solver, solver.from_cold(), false);
  });
} catch (const SearchFailure& failure) {
  return {failure.status, {}, {}, 0, 0, 0};
}

SteadyHeat steady_heat_near(const MotorDesign& design, const LoadPoint& load,
                            double temperature) try {
  return solved_by<SteadyHeat>(design, load, [&](const HeatSolver& solver) {
    return answer_of(solver, solver.near({temperature, temperature, temperature}), true);
  });
} catch (const SearchFailure& failure) {
  return {failure.status, {}, {}, 0, 0, 0};
}

std::vector<WarmUpPoint> warm_up(const MotorDesign& design, const LoadPoint& load,
                                 const std::vector<double>& times) try {
  return solved_by<std::vector<WarmUpPoint>>(design, load, [&](const HeatSolver& solver) {
    std::vector<WarmUpPoint> points;
    HeatState state = solver.cold();
    for (const double time : times) {
      if (time > state.time) state = solver.advanced(state, time - state.time, kStepError);
      points.push_back({state.status, state.time, {}, {}});
      if (state.status != MetricStatus::ok) break;
      points.back().temperatures = parts_of(solver.parts(state));
      points.back().losses = losses_of(state.p);
    }
    return points;
  });
} catch (const SearchFailure& failure) {
  return {{failure.status, 0, {}, {}}};
}

namespace {

// The distribution of the losses follows the temperatures, and these the losses: a few rounds.
HeatBalance balance_at(const HeatSolver& solver, const LoadLosses& losses, double ambient,
                       double temperature) {
  constexpr int kMostRounds = 40;
  constexpr double kSettled = 1e-6;  // [K]
  NodeTemperatures x{temperature, temperature, temperature};
  for (int i = 0; i < kMostRounds; ++i) {
    const WarmLosses found = losses.at(x);
    if (found.status != MetricStatus::ok) return {found.status, temperature, 0, 0};
    const double rise = dot(solver.response()[kNodeParts[0]], found.p);
    const double share = (temperature - ambient) / rise;
    NodeTemperatures next{};
    for (std::size_t k = 0; k < 3; ++k)
      next[k] = ambient + share * dot(solver.response()[kNodeParts[k]], found.p);
    const double sum = losses_of(found.p).sum();
    if (!(rise > 0)) return {MetricStatus::undefined, temperature, 0, 0};
    const bool settled = largest(plus(next, -1, x)) <= kSettled;
    x = next;
    if (settled) return {MetricStatus::ok, temperature, sum, share * sum};
  }
  return {MetricStatus::not_converged, temperature, 0, 0};
}

}  // namespace

std::vector<HeatBalance> heat_balance(const MotorDesign& design, const LoadPoint& load,
                                      const std::vector<double>& stator_temperatures) try {
  const HeldTraps traps;
  require_heat(design);
  MotorDesign kept = design;
  keep_plate(kept);
  const LoadLosses losses(kept, load);
  const double ambient = kept.thermal->ambient;
  const HeatSolver solver(
      {network_of(kept), ambient, [&](const NodeTemperatures& x) { return losses.at(x); }});
  std::vector<HeatBalance> balance;
  for (const double temperature : stator_temperatures)
    balance.push_back(balance_at(solver, losses, ambient, temperature));
  return balance;
} catch (const SearchFailure& failure) {
  return std::vector<HeatBalance>(stator_temperatures.size(), {failure.status, 0, 0, 0});
}

}  // namespace twum::inline v0_1
