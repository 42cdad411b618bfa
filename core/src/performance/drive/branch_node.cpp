// SPDX-License-Identifier: Apache-2.0
#include "performance/drive/branch_node.hpp"

#include <utility>

namespace twum::performance {
namespace {

using contact::LayerState;
using contact::Matrix2;
using contact::StateSlopes;

LayerState<double> combined(double u, const LayerState<double>& a, double t,
                            const LayerState<double>& b) {
  return {u * a.e + t * b.e, u * a.rate + t * b.rate};
}

StateSlopes combined(double u, const StateSlopes& a, double t, const StateSlopes& b) {
  const Matrix2 &p = a.resolvent, &q = b.resolvent;
  return {{u * p.a + t * q.a, u * p.b + t * q.b, u * p.c + t * q.c, u * p.d + t * q.d},
          combined(u, a.in_speed, t, b.in_speed),
          combined(u, a.in_amplitude, t, b.in_amplitude),
          combined(u, a.of_power, t, b.of_power),
          combined(u, a.of_force, t, b.of_force)};
}

// Shares of Hermite's cubic: of the values at both ends, and of their slopes.
struct Hermite {
  Hermite(double length, double t)
      : at_a((1 - t) * (1 - t) * (1 + 2 * t)),
        at_b(t * t * (3 - 2 * t)),
        slope_a(t * (1 - t) * (1 - t) * length),
        slope_b(-t * t * (1 - t) * length) {}
  double at_a, at_b, slope_a, slope_b;
};

// How the state at entry moves along the branch.
LayerState<double> along(const BranchNode& node, std::size_t k) {
  const StateSlopes& s = node.states[k];
  return combined(1, s.in_speed, node.slope, s.in_amplitude);
}

bool same_slices(const BranchNode& a, const BranchNode& b) {
  return a.states.size() == b.states.size() && a.start.size() == b.start.size() &&
         a.states.size() == a.start.size();
}

}  // namespace

WarmStart moved(const WarmStart& start, const MovingStates& states, double step) {
  WarmStart result = start;
  for (std::size_t k = 0; k < states.size(); ++k) {
    LayerState<double>& layer = result.of_slice(k).layer;
    layer = combined(1, layer, step, states[k].in_amplitude);
  }
  return result;
}

BranchNode branch_node(DrivenWaves::LevelSlopes wave, double step, bool grows) {
  const SlopedWave& w = wave.in_amplitude;
  WarmStart start = w.wave.start;
  if (wave.states.size() == start.size()) start = moved(start, wave.states, step);
  return {w.wave.speed, w.wave.amplitude + step, wave.amplitude_per_speed, w.force_slope(),
          grows,        std::move(wave.solved),  std::move(start),         std::move(wave.states)};
}

BranchGuess guess_between(const BranchNode& a, const BranchNode& b, double speed) {
  const double length = b.speed - a.speed, t = (speed - a.speed) / length, u = 1 - t;
  const Hermite h(length, t);
  BranchGuess guess{
      h.at_a * a.amplitude + h.at_b * b.amplitude + h.slope_a * a.slope + h.slope_b * b.slope,
      u * a.force_slope + t * b.force_slope,
      WarmStart::beyond(a.start, b.start, -u),
      {}};
  if (!same_slices(a, b)) return guess;
  guess.states.reserve(a.states.size());
  for (std::size_t k = 0; k < a.states.size(); ++k) {
    guess.states.push_back(combined(u, a.states[k], t, b.states[k]));
    guess.start.of_slice(k).layer =
        combined(1, combined(h.at_a, a.start.of_slice(k).layer, h.at_b, b.start.of_slice(k).layer),
                 1, combined(h.slope_a, along(a, k), h.slope_b, along(b, k)));
  }
  return guess;
}

}  // namespace twum::performance
