// SPDX-License-Identifier: Apache-2.0
#include "drive/curve_node.hpp"

#include "drive/rules.hpp"

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::core {
namespace {

using contact::LayerState;
using contact::Matrix2;
using contact::StateSlopes;

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
  Shares(const CurveNode& a, const CurveNode& b, const std::array<const CurveNode*, 2>& beside,
         double place) {
    for (const CurveNode* node : {&a, &b, beside[0], beside[1]})
      if (node) nodes_[count_++] = node;
    for (std::size_t i = 0; i < count_; ++i) {
      weights_[i] = 1;
      for (std::size_t j = 0; j < count_; ++j)
        if (j != i)
          weights_[i] *= (place - nodes_[j]->place) / (nodes_[i]->place - nodes_[j]->place);
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
  const CurveNode* nodes_[4];
  double weights_[4];
  std::size_t count_{0};
};

// How the state at entry moves along the curve.
LayerState<double> along(const CurveNode& node, std::size_t k) {
  const StateSlopes& s = node.states[k];
  return combined(node.parameter_rate, s.in_speed, node.amplitude_rate, s.in_amplitude);
}

}  // namespace

bool same_slices(const CurveNode& a, const CurveNode& b) {
  return a.states.size() == b.states.size() && a.start.size() == b.start.size() &&
         a.states.size() == a.start.size();
}

WarmStart moved(const WarmStart& start, const MovingStates& states, double step, double turn) {
  WarmStart result = start;
  if (states.size() != start.size()) return result;
  for (std::size_t k = 0; k < states.size(); ++k) {
    LayerState<double>& layer = result.of_slice(k).layer;
    layer = combined(1, layer, step, states[k].in_amplitude);
    if (turn != 0) layer = combined(1, layer, turn, states[k].in_speed);
  }
  return result;
}

PointNumbers<double> moved(const PointNumbers<contact::MotionDual>& n, double step, double turn) {
  const auto at_end = [step, turn](const contact::MotionDual& x) {
    return x.v + step * x.d[contact::kInAmplitude] + turn * x.d[contact::kInSpeed];
  };
  return {at_end(n.torque),     at_end(n.stator_power),   at_end(n.friction_power),
          at_end(n.layer_loss), at_end(n.stick_fraction), at_end(n.reactive_force)};
}

PlanePoint cubic(const CurveNode& a, const CurveNode& b, double t) {
  const Hermite h(b.place - a.place, t);
  return {h.at_a * a.at.x + h.at_b * b.at.x + h.slope_a * a.along.x + h.slope_b * b.along.x,
          h.at_a * a.at.y + h.at_b * b.at.y + h.slope_a * a.along.y + h.slope_b * b.along.y};
}

double place_of(const CurveNode& a, const CurveNode& b, double y) {
  const bool rises = b.at.y > a.at.y;
  double low = 0, high = 1, t = (y - a.at.y) / (b.at.y - a.at.y);
  for (int i = 0; i < kRules.most_tries; ++i) {
    const double off = cubic(a, b, t).y - y;
    if (off == 0) return t;
    ((off > 0) == rises ? high : low) = t;
    // Hermite's cubic again, by its own slope.
    const double length = b.place - a.place, u = 1 - t,
                 slope = 6 * t * u * (b.at.y - a.at.y) +
                         length * (u * (1 - 3 * t) * a.along.y + t * (3 * t - 2) * b.along.y);
    double next = t - off / slope;
    if (!(next >= low && next <= high)) next = 0.5 * (low + high);
    if (std::fabs(next - t) < kRules.extremum) return next;  // its square is left
    t = next;
  }
  return t;
}

// The slope of the cubic of y over x is a parabola; it has zeros between two ends of one sign if its vertex there has the other,
// and may have if that is small.
bool hides_folds(const CurveNode& a, const CurveNode& b) {
  const double apart = b.at.x - a.at.x, p = a.along.y / a.along.x * apart,
               q = b.along.y / b.along.x * apart;
  if (!((a.along.x > 0) == (apart > 0) && (b.along.x > 0) == (apart > 0))) return false;
  const double bend = 3 * (p + q) - 6 * (b.at.y - a.at.y), slope = q - p - bend;
  const double vertex = -0.5 * slope / bend;
  if ((p > 0) != (q > 0) || !(vertex > 0 && vertex < 1)) return false;
  const double sign = p > 0 ? 1 : -1, least = sign * (p + vertex * (slope + bend * vertex));
  return least < kRules.nearly_flat * std::fmin(std::fabs(p), std::fabs(q));
}

WarmStart start_between(const CurveNode& a, const CurveNode& b, double t) {
  WarmStart start = t < 0.5 ? WarmStart::extrapolated(b.start, a.start, -t)
                            : WarmStart::extrapolated(a.start, b.start, t - 1);
  if (!same_slices(a, b)) return start;
  const Hermite h(b.place - a.place, t);
  for (std::size_t k = 0; k < a.states.size(); ++k)
    start.of_slice(k).layer =
        combined(1, combined(h.at_a, a.start.of_slice(k).layer, h.at_b, b.start.of_slice(k).layer),
                 1, combined(h.slope_a, along(a, k), h.slope_b, along(b, k)));
  return start;
}

CurveGuess guess_between(const CurveNode& a, const CurveNode& b, double t,
                         const std::array<const CurveNode*, 2>& beside) {
  const Shares shares(a, b, beside, a.place + t * (b.place - a.place));
  CurveGuess guess{std::exp(cubic(a, b, t).x),
                   shares.force_slope(),
                   start_between(a, b, t),
                   {},
                   shares.count() == 4 ? kRules.left_by_turn : 1};
  if (!same_slices(a, b)) return guess;
  guess.states.reserve(a.states.size());
  for (std::size_t k = 0; k < a.states.size(); ++k) guess.states.push_back(shares.of_slice(k));
  return guess;
}

}  // namespace twum::inline v0_1::core
