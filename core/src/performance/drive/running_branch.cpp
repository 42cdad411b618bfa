// SPDX-License-Identifier: Apache-2.0
#include "performance/drive/running_branch.hpp"

#include <twum/base/scalar_search.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace twum::performance {
namespace {

constexpr int kSteps = 24;         // of the grid up to the crest speed
constexpr int kStepsTraced = 32;   // to beyond no-load
constexpr int kBraking = 2;        // steps of the grid from node to node beyond no-load
constexpr double kFar = 200;       // steps of the grid after which the branch is no longer followed
constexpr double kSearched = 1.3;  // of the crest speed; no motor runs by itself at higher speeds
// of the amplitude; a larger distance from the tangent means another branch or too large a step
constexpr double kStraight = 0.02;
constexpr double kRestOfStep = 1 - 1e-9;  // of what is left: rounding leaves no step of its own
constexpr double kShortestStep = 1e-3;    // of the step of the grid: shortest step before a fold
// limit of zones followed for the nodes; usual motors need a thousand
constexpr long kMostZones = 200'000;
constexpr int kMostSecants = 12;
// of the amplitude; the error after the last Newton step is its square
constexpr double kNodeSettled = 3e-4;
constexpr double kNodeAccuracy = 1e-9;  // of the layer's state at a node, as of its amplitude
constexpr double kSettled = 1e-13;      // of the amplitude; largest error after the last secant
constexpr double kReach = 0.2;  // of the amplitude: largest step of a secant, or from node to node
// of the amplitude and of the layer's state: largest distance of the guess from where the first step leads
constexpr double kFarGuess = 1e-2;
// of the amplitude and of the layer's state: largest error after the last step of Newton's method
constexpr double kSettledTurn = 1e-12;
constexpr int kMostFollowed = 8;  // turns
// of the drive's force; an amplitude right to kSettled leaves a hundredth of it, a zone that is not there far more
constexpr double kBalanced = 1e-11;

// The largest running solution.
std::optional<DrivenWave> largest(const std::vector<WaveSolution>& solutions) {
  for (auto s = solutions.rbegin(); s != solutions.rend(); ++s)
    if (s->running()) return s->wave();
  return {};
}

}  // namespace

RunningBranch::RunningBranch(const DrivenWaves& waves, const std::vector<ForceExtremum>& extrema)
    : waves_(waves) {
  const std::optional<Node> first = first_node(extrema);
  if (!first) return;
  nodes_.push_back(*first);
  step_ = waves.crest_speed_per_amplitude() * first->amplitude / kSteps;
  if (!std::isfinite(step_)) {
    nodes_.clear();
    return;
  }
  upper_ = follow(step_, kStepsTraced);
  if (first->speed == 0) return;
  std::reverse(nodes_.begin(), nodes_.end());
  lower_ = follow(-step_, kStepsTraced);
  std::reverse(nodes_.begin(), nodes_.end());
}

// Between the extrema of H if that is enough to find it.
std::optional<DrivenWave> RunningBranch::running_at_rest(
    const std::vector<ForceExtremum>& extrema) const {
  if (!extrema.empty() && !waves_.has_static_excess())
    if (const auto wave = largest(wave_solutions(waves_, 0, extrema).found)) return wave;
  return largest(wave_solutions(waves_, 0).found);
}

// The node at rest, or at the lowest speed of a grid with a running solution.
std::optional<RunningBranch::Node> RunningBranch::first_node(
    const std::vector<ForceExtremum>& extrema) const {
  if (const auto at_rest = running_at_rest(extrema))
    return node(0, at_rest->amplitude, &at_rest->start).node;
  double hold = 0;
  for (const ForceExtremum& e : extrema)
    if (!e.maximum) hold = e.amplitude;
  const double step = waves_.crest_speed_per_amplitude() * hold / kSteps;
  long zones = 0;
  for (int i = 1; hold > 0 && i <= kSearched * kSteps && zones < kMostZones; ++i) {
    const WaveSolutions solutions = wave_solutions(waves_, i * step);
    zones += solutions.zones;
    if (const auto found = largest(solutions.found))
      return node(i * step, found->amplitude, &found->start).node;
  }
  return {};
}

// Newton steps for H(A) = Theta u_0 near a guess, and the slope of the level curve (D2.9). Nodes only start other
// searches, so the last step is not solved again.
RunningBranch::NodeSearch RunningBranch::node(double speed, double guess, const WarmStart* start,
                                              const SolvedPoint* near) const {
  double a = guess;
  long zones = 0;
  WarmStart from;
  DrivenWaves::LevelSlopes s;
  for (int i = 0; i < kMostSecants; ++i) {
    s = waves_.slopes(a, speed, start, kNodeAccuracy, near);
    const SlopedWave& w = s.in_amplitude;
    zones += w.wave.zones;
    if (w.wave.status != PointStatus::ok || !(w.fold() > 0)) return {{}, zones};
    const double step = (waves_.drive() - w.wave.force()) / w.force_slope();
    a += step;
    if (!(std::fabs(a - guess) <= kStraight * guess)) return {{}, zones};
    if (std::fabs(step) <= kNodeSettled * a) {
      const bool grows = !(waves_.stability(w).trace < 0);
      return {branch_node(std::move(s), step, grows), zones};
    }
    from = moved(w.wave.start, s.states, step), start = &from, near = &s.solved;
  }
  return {{}, zones};
}

// Newton's method for H(A) = Theta u_0 and the layer's states together, one turn of the wave a step, with the slopes of the
// nodes: they are off by a small share, of which the last two steps tell how much they leave. Nothing unless that is quick.
std::optional<BranchWave> RunningBranch::followed(double speed, const BranchGuess& guess,
                                                  const SolvedPoint& near) const {
  if (!(guess.force_slope > 0)) return {};
  double a = guess.amplitude, last = 0;
  WarmStart from = guess.start;
  for (int i = 0; i < kMostFollowed; ++i) {
    const auto turn = near.newton_turn(waves_.motor(a), speed, from, guess.states);
    if (!turn) return {};
    const double excess = waves_.balance(turn->numbers, a).force() - waves_.drive();
    const double step = -excess / guess.force_slope;
    if (!(std::fabs(step) <= kReach * guess.amplitude)) return {};
    from = moved(turn->next, guess.states, step);
    a += step;
    const double off = std::fmax(std::fabs(step) / a, turn->gap);
    if (!(off <= (i == 0 ? kFarGuess : kReach * last))) return {};
    if (off * (i == 0 ? guess.left : off / last) <= kSettledTurn) return BranchWave{a, speed, from};
    last = off;
  }
  return {};
}

// Secants for H(A) = Theta u_0 from a wave that is solved, in the direction in which H rises with A. Each step starts from the
// layer's state of the last one.
std::optional<MotorPoint> RunningBranch::polished(double speed, double guess, SolvedPoint at_guess,
                                                  double force_slope) const {
  double slope = force_slope, before = 0, excess_before = 0;
  MotorPoint at{waves_.motor(guess), std::move(at_guess)};
  WarmStart last = at.solved.start();
  for (int i = 0; i < kMostSecants && at.solved.status == PointStatus::ok; ++i) {
    const double a = at.motor.amplitude;
    const double excess = waves_.balance(at.solved.numbers, a).force() - waves_.drive();
    if (i > 0 && a != before) slope = (excess - excess_before) / (a - before);
    if (!(slope > 0)) return {};
    const double step = -excess / slope;
    if (!(std::fabs(step) <= kReach * guess)) return {};
    const WarmStart here = at.solved.start();
    const WarmStart from =
        i > 0 && a != before ? WarmStart::beyond(last, here, step / (a - before)) : here;
    at.motor = waves_.motor(a + step);
    at.solved = waves_.has_static_excess() ? solve_point_near(at.motor, speed, at.solved, from)
                                           : solve_point(at.motor, speed, &from);
    // The error of a secant is the product of the last two steps over a length of the order of the amplitude.
    const double last_step = i > 0 ? a - before : kReach * a;
    if (std::fabs(step * last_step) <= kSettled * a * a) return at;
    last = here, before = a, excess_before = excess;
  }
  return {};
}

std::optional<MotorPoint> RunningBranch::polished(const Node& node) const {
  const WarmStart start = node.solved.start();
  return polished(node.speed, node.amplitude,
                  solve_point(waves_.motor(node.amplitude), node.speed, &start), node.force_slope);
}

// Predicts by the cubic through the last two nodes, or by the tangent. Beside a fold these may lead far away, and to a wave of
// another branch.
RunningBranch::NodeSearch RunningBranch::stepped(const Node& from, double speed,
                                                 const Node* before) const {
  const double d = speed - from.speed;
  double amplitude = from.amplitude + from.slope * d;
  WarmStart start;
  if (before && std::fabs(from.speed - before->speed) >= 0.5 * std::fabs(d)) {
    BranchGuess guess = guess_between(*before, from, speed);
    amplitude = guess.amplitude, start = std::move(guess.start);
  } else {
    start = from.solved.start();
  }
  if (!(std::fabs(amplitude - from.amplitude) <= kReach * from.amplitude)) return {{}, 0};
  return node(speed, amplitude, &start, &from.solved);
}

// Continues from the last node, with steps that are halved where the branch bends.
BranchEnd RunningBranch::follow(double step, int steps) {
  const BranchEnd endless{std::copysign(std::numeric_limits<double>::infinity(), step), 0};
  const double first = nodes_.back().speed;
  long zones = 0;
  const auto brakes = [this] { return nodes_.back().solved.numbers.torque < 0; };
  for (int i = 1; i <= steps; i += brakes() ? kBraking : 1) {
    const double target = first + i * step;
    double stride = target - nodes_.back().speed;
    while (nodes_.back().speed != target) {
      if (zones > kMostZones) return endless;
      const Node& last = nodes_.back();
      const bool reaches = std::fabs(stride) >= kRestOfStep * std::fabs(target - last.speed);
      const double next = reaches ? target : last.speed + stride;
      const Node* before = nodes_.size() > 1 ? &nodes_[nodes_.size() - 2] : nullptr;
      const NodeSearch search = stepped(last, next, before);
      zones += search.zones;
      if (search.node) {
        nodes_.push_back(*search.node);
      } else {
        stride *= 0.5;
        if (std::fabs(stride) < kShortestStep * std::fabs(step)) return fold_beyond(last, next);
      }
    }
  }
  return endless;
}

// Secants for H_A = 0, since a search for the minimum finds its position only to the square root of rounding.
double RunningBranch::fold_amplitude(double speed, double near) const {
  double a = near * (1 + 1e-5), b = near;
  double at_a = waves_.in_amplitude(a, speed).fold(), at_b = waves_.in_amplitude(b, speed).fold();
  for (int i = 0; i < 4 && at_a != at_b; ++i) {
    const double next = b - at_b * (b - a) / (at_b - at_a);
    if (!(std::fabs(next - near) < 1e-4 * near)) return near;
    a = b, at_a = at_b;
    b = next, at_b = waves_.in_amplitude(b, speed).fold();
  }
  return b;
}

// The fold at which the least force near the branch equals the force of the drive.
BranchEnd RunningBranch::fold_beyond(const Node& last, double speed) const {
  const double low = last.amplitude / 1.5, high = last.amplitude * 1.02;
  const auto missing = [&](double at) {
    return least_force(waves_, at, low, high).force - waves_.drive();
  };
  double inside = last.speed, outside = speed;
  const double at_inside = missing(inside);
  double at_outside = missing(outside);
  for (int i = 0; i < 12 && !(at_outside > 0); ++i)
    at_outside = missing(outside += 0.1 * std::copysign(step_, speed - last.speed));
  if (!(at_inside < 0 && at_outside > 0)) return {last.speed, last.amplitude};
  const bool upward = outside > inside;
  const Bracket ends = upward ? Bracket{inside, outside, at_inside, at_outside}
                              : Bracket{outside, inside, at_outside, at_inside};
  const Bracket fold = closed_in("the speed at which the running branch ends", missing, ends, 48);
  const double end = upward ? fold.low : fold.high;
  return {end, fold_amplitude(end, least_force(waves_, end, low, high).amplitude)};
}

double RunningBranch::first_amplitude() const {
  return lower_.pulls_out() ? lower_.amplitude : nodes_.front().amplitude;
}

// Bisects where H passes from below the drive's force to above.
std::optional<BranchWave> RunningBranch::bracketed(double speed, double low, double high) const {
  const auto excess = [&](double a) { return waves_.at(a, speed).force() - waves_.drive(); };
  const double at_low = excess(low), at_high = excess(high);
  if (!(at_low < 0 && at_high > 0)) return {};
  const double amplitude = closed_in("an amplitude of the running branch", excess, {low, high, at_low, at_high}).high;
  return BranchWave{amplitude, speed, waves_.at(amplitude, speed).start};
}

// Continues from a node to a speed between the last node and an end. Near a fold the amplitude changes like the
// square root of the distance and lies above that of the fold.
std::optional<MotorPoint> RunningBranch::beyond(const Node& last, const BranchEnd& end,
                                                double speed) const {
  if (end.pulls_out())
    if (const auto wave = bracketed(speed, end.amplitude, last.amplitude * (1 + kStraight)))
      return solved(*wave);
  if (std::fabs(speed - last.speed) > kFar * step_) {
    const std::optional<DrivenWave> far = largest(wave_solutions(waves_, speed).found);
    return far ? std::optional(solved({far->amplitude, speed, far->start})) : std::nullopt;
  }
  Node at = last;
  double stride = std::copysign(step_, speed - last.speed);
  while (at.speed != speed) {
    const bool reaches = std::fabs(stride) >= kRestOfStep * std::fabs(speed - at.speed);
    const double next = reaches ? speed : at.speed + stride;
    if (const std::optional<Node> found = stepped(at, next).node) {
      at = *found;
    } else {
      stride *= 0.5;
      if (std::fabs(stride) < 1e-9 * step_) return {};
    }
  }
  return polished(at);
}

MotorPoint RunningBranch::solved(const BranchWave& wave) const {
  const DrivenMotor<double> motor = waves_.motor(wave.amplitude);
  return {motor, solve_point(motor, wave.speed, &wave.start)};
}

bool RunningBranch::balances(const MotorPoint& p) const {
  const double force = waves_.balance(p.solved.numbers, p.motor.amplitude).force();
  return p.solved.status == PointStatus::ok &&
         std::fabs(force - waves_.drive()) <= kBalanced * waves_.drive();
}

// The wave that turns through the zones near a point lead to. Only its own contact can tell whether its zones are these.
std::optional<MotorPoint> RunningBranch::proven(double speed, const BranchGuess& guess,
                                                const SolvedPoint& near) const {
  const auto wave = followed(speed, guess, near);
  if (!wave) return {};
  MotorPoint point{waves_.motor(wave->amplitude), {}};
  point.solved = solve_point_near(point.motor, speed, near, wave->start);
  return balances(point) ? std::optional(std::move(point)) : std::nullopt;
}

// The nodes beside two neighbours, null where they have other zones than both.
std::array<const RunningBranch::Node*, 2> RunningBranch::beside(const Node& a,
                                                                const Node& b) const {
  const std::uint64_t zones = a.solved.signature();
  if (b.solved.signature() != zones) return {};
  const auto if_like = [&](const Node& n) {
    return n.solved.signature() == zones && same_slices(n, a) ? &n : nullptr;
  };
  const auto k = static_cast<std::size_t>(&a - nodes_.data());
  return {k > 0 ? if_like(nodes_[k - 1]) : nullptr,
          k + 2 < nodes_.size() ? if_like(nodes_[k + 2]) : nullptr};
}

// Through the zones of the nearer node, or where those do not lead there, of the guess itself: zones begin and end between
// nodes. As splits move with the speed, a track that is split has those of the guess, and its slopes where the nodes have other slices.
// Those at a jump move with the amplitude as well, so that no turn through the zones of the guess leads to the wave.
std::optional<MotorPoint> RunningBranch::between(const Node& a, const Node& b, double speed) const {
  BranchGuess guess = guess_between(a, b, speed, beside(a, b));
  if (!waves_.splits()) {
    const Node& nearer = speed - a.speed < b.speed - speed ? a : b;
    if (auto point = proven(speed, guess, nearer.solved)) return point;
  }
  const SolvedPoint near =
      solve_point(waves_.motor(guess.amplitude), speed, &guess.start, kNodeAccuracy);
  if (near.status == PointStatus::ok && !near.jumps()) {
    guess.start = near.start();
    if (guess.states.size() != guess.start.size())
      guess.states = waves_.moving(near, guess.amplitude, speed).states;
    if (auto point = proven(speed, guess, near)) return point;
  }
  if (auto point = polished(speed, guess.amplitude, near, guess.force_slope)) return point;
  return beyond(a, {HUGE_VAL, 0}, speed);
}

std::optional<MotorPoint> RunningBranch::at(double speed) const {
  if (nodes_.empty() || speed < lower_.speed || speed > upper_.speed) return {};
  for (const BranchEnd& end : {lower_, upper_})
    if (speed == end.speed) return solved({end.amplitude, speed, nodes_.front().solved.start()});
  const auto above = std::upper_bound(nodes_.begin(), nodes_.end(), speed,
                                      [](double s, const Node& n) { return s < n.speed; });
  if (above == nodes_.begin()) return beyond(nodes_.front(), lower_, speed);
  const Node& a = *(above - 1);
  if (a.speed == speed) return polished(a);
  if (above == nodes_.end()) return beyond(a, upper_, speed);
  return between(a, *above, speed);
}

// The trace changes little between two nodes, so it is computed only if a disturbance grows at one of them.
bool RunningBranch::steady(const MotorPoint& point, double speed) const {
  const auto above = std::upper_bound(nodes_.begin(), nodes_.end(), speed,
                                      [](double s, const Node& n) { return s < n.speed; });
  const bool inside = above != nodes_.begin() && above != nodes_.end();
  if (inside && !above->grows && !(above - 1)->grows) return true;
  const WarmStart start = point.solved.start();
  return waves_.stability(waves_.in_amplitude(point.motor.amplitude, speed, &start)).trace < 0;
}

}  // namespace twum::performance
