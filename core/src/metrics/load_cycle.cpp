// SPDX-License-Identifier: Apache-2.0
// Cycles of loads with losses that follow the temperatures.
#include "curve/curve.hpp"
#include "design/held_traps.hpp"
#include "metrics/load_losses.hpp"

#include <twum/base/error.hpp>
#include <twum/core/plate.hpp>
#include <twum/core/steady_heat.hpp>

#include <cmath>

namespace twum {

using namespace core;

namespace {

constexpr double kCycleError = 1e-3;  // of a step in time [K]
constexpr double kReturned = 1e-6;    // [K]
constexpr int kMostCycles = 20;

class CycleSolver {
 public:
  CycleSolver(const MotorDesign& design, const std::vector<LoadPhase>& phases) : phases_(phases) {
    const HeatNetwork network = network_of(design);
    for (const LoadPhase& phase : phases)
      solvers_.emplace_back(
          HeatProblem{network, design.thermal->ambient, losses_of(design, phase)});
  }

  /// Newton's method on the map of a cycle, from the periodic state under the losses of the cold motor (H5.1).
  LoadCycle solve() const {
    Vector3 theta = first_guess();
    for (int i = 0; i < kMostCycles; ++i) {
      const Lap lap = run(theta);
      if (lap.cycle.status != MetricStatus::ok) return lap.cycle;
      const Vector3 off = plus(lap.end, -1, theta);
      if (largest(off) <= kReturned) return lap.cycle;
      theta = plus(theta, 1, inverse(plus(kIdentity3, -1, lap.moved)) * off);
    }
    return {MetricStatus::thermally_unstable, {}};
  }

 private:
  struct Lap {
    LoadCycle cycle;
    Vector3 end{};
    Matrix3 moved{kIdentity3};
  };

  static LossesAt losses_of(const MotorDesign& design, const LoadPhase& phase) {
    if (!phase.load) return [](const NodeTemperatures&) { return WarmLosses{}; };
    const LoadLosses losses(design, *phase.load);
    return [losses](const NodeTemperatures& x) { return losses.at(x); };
  }

  Vector3 first_guess() const {
    // The cycle as a map of theta with the losses of the cold motor is linear: theta = E theta + v.
    Vector3 v{};
    Matrix3 all = kIdentity3;
    for (std::size_t i = 0; i < phases_.size(); ++i) {
      const HeatSolver::Linear map = solvers_[i].with_cold_losses(phases_[i].time);
      v = plus(map.E * v, 1, map.v);
      all = map.E * all;
    }
    return inverse(plus(kIdentity3, -1, all)) * v;
  }

  Lap run(const Vector3& start) const {
    Lap lap;
    lap.end = start;
    NodeTemperatures guess = solvers_.front().cold_nodes();
    for (std::size_t i = 0; i < phases_.size(); ++i) {
      HeatState state = solvers_[i].at_masses(lap.end, guess);
      if (state.status == MetricStatus::ok) {
        lap.cycle.states.push_back(parts_of(solvers_[i].parts(state)));
        state = solvers_[i].advanced(state, phases_[i].time, kCycleError);
      }
      if (state.status != MetricStatus::ok) return {{state.status, {}}, {}, {}};
      lap.end = state.theta, lap.moved = state.moved * lap.moved;
      guess = state.x;
      if (i + 1 == phases_.size()) lap.cycle.states.push_back(parts_of(solvers_[i].parts(state)));
    }
    return lap;
  }

  const std::vector<LoadPhase>& phases_;
  std::vector<HeatSolver> solvers_;
};

}  // namespace

LoadCycle load_cycle(const MotorDesign& design, const std::vector<LoadPhase>& phases) try {
  const HeldTraps traps;
  require_motor(design);
  if (!design.thermal) throw InputError("the motor needs 'thermal' for its temperatures");
  if (phases.empty()) throw InputError("a cycle needs at least one phase");
  for (const LoadPhase& phase : phases)
    if (!(phase.time > 0)) throw InputError("a phase of a cycle needs a time of more than 0 s");
  MotorDesign kept = design;
  keep_plate(kept);
  return CycleSolver(kept, phases).solve();
} catch (const SearchFailure& failure) {
  return {failure.status, {}};
}

}  // namespace twum
