// SPDX-License-Identifier: Apache-2.0
#include "performance/drive/branch_node.hpp"

#include <utility>

namespace twum::performance {
namespace {

using contact::LayerState;
using contact::Matrix2;
using contact::StateSlopes;

// What a step of Newton's method with the slopes of four nodes leaves of the guess's error in usual motors. The proof of the
// point and the balance of its drive tell where it is more.
constexpr double kLeftByTurn = 1e-5;

LayerState<double> combined(double u, const LayerState<double>& a, double t,
                            const LayerState<double>& b) {
  return {u * a.e + t * b.e, u * a.rate + t * b.rate};
}

void add(StateSlopes& sum, double t, const StateSlopes& s) {
  Matrix2& r = sum.resolvent;
  r = {r.a + t * s.resolvent.a, r.b + t * s.resolvent.b, r.c + t * s.resolvent.c,
       r.d + t * s.resolvent.d};
  sum.in_speed = combined(1, sum.in_speed, t, s.in_speed);
  sum.in_amplitude = combined(1, sum.in_amplitude, t, s.in_amplitude);
  sum.of_power = combined(1, sum.of_power, t, s.of_power);
  sum.of_force = combined(1, sum.of_force, t, s.of_force);
}

PointNumbers<double> moved(const PointNumbers<contact::MotionDual>& n, double step) {
  const auto at_end = [step](const contact::MotionDual& x) {
    return x.v + step * x.d[contact::kInAmplitude];
  };
  return {at_end(n.torque),     at_end(n.stator_power),   at_end(n.friction_power),
          at_end(n.layer_loss), at_end(n.stick_fraction), at_end(n.reactive_force)};
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

// Shares of some nodes in the polynomial through them, by Lagrange's formula.
class Shares {
 public:
  Shares(const BranchNode& a, const BranchNode& b, const std::array<const BranchNode*, 2>& beside,
         double speed) {
    for (const BranchNode* node : {&a, &b, beside[0], beside[1]})
      if (node) nodes_[count_++] = node;
    for (std::size_t i = 0; i < count_; ++i) {
      weights_[i] = 1;
      for (std::size_t j = 0; j < count_; ++j)
        if (j != i)
          weights_[i] *= (speed - nodes_[j]->speed) / (nodes_[i]->speed - nodes_[j]->speed);
    }
  }

  std::size_t count() const { return count_; }
  double force_slope() const {
    double sum = 0;
    for (std::size_t i = 0; i < count_; ++i) sum += weights_[i] * nodes_[i]->force_slope;
    return sum;
  }
  StateSlopes of_slice(std::size_t k) const {
    StateSlopes sum{{0, 0, 0, 0}, {0, 0}, {0, 0}, {0, 0}, {0, 0}};
    for (std::size_t i = 0; i < count_; ++i) add(sum, weights_[i], nodes_[i]->states[k]);
    return sum;
  }

 private:
  const BranchNode* nodes_[4];
  double weights_[4];
  std::size_t count_{0};
};

// How the state at entry moves along the branch.
LayerState<double> along(const BranchNode& node, std::size_t k) {
  const StateSlopes& s = node.states[k];
  return combined(1, s.in_speed, node.slope, s.in_amplitude);
}

}  // namespace

bool same_slices(const BranchNode& a, const BranchNode& b) {
  return a.states.size() == b.states.size() && a.start.size() == b.start.size() &&
         a.states.size() == a.start.size();
}

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
  wave.solved.numbers = moved(wave.numbers, step);
  return {w.wave.speed, w.wave.amplitude + step, wave.amplitude_per_speed, w.force_slope(),
          grows,        std::move(wave.solved),  std::move(start),         std::move(wave.states)};
}

BranchGuess guess_between(const BranchNode& a, const BranchNode& b, double speed,
                          const std::array<const BranchNode*, 2>& beside) {
  const double length = b.speed - a.speed, t = (speed - a.speed) / length, u = 1 - t;
  const Hermite h(length, t);
  const Shares shares(a, b, beside, speed);
  BranchGuess guess{
      h.at_a * a.amplitude + h.at_b * b.amplitude + h.slope_a * a.slope + h.slope_b * b.slope,
      shares.force_slope(),
      t < 0.5 ? WarmStart::beyond(b.start, a.start, -t) : WarmStart::beyond(a.start, b.start, -u),
      {},
      shares.count() == 4 ? kLeftByTurn : 1};
  if (!same_slices(a, b)) return guess;
  guess.states.reserve(a.states.size());
  for (std::size_t k = 0; k < a.states.size(); ++k) {
    guess.states.push_back(shares.of_slice(k));
    guess.start.of_slice(k).layer =
        combined(1, combined(h.at_a, a.start.of_slice(k).layer, h.at_b, b.start.of_slice(k).layer),
                 1, combined(h.slope_a, along(a, k), h.slope_b, along(b, k)));
  }
  return guess;
}

}  // namespace twum::performance
