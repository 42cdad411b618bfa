// SPDX-License-Identifier: Apache-2.0
#include "drive/wave_curve.hpp"

#include "curve/speed_roots.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace twum::inline v0_1::core {
namespace {

double distance(PlanePoint a, PlanePoint b) { return std::hypot(b.x - a.x, b.y - a.y); }

double dot(PlanePoint a, PlanePoint b) { return a.x * b.x + a.y * b.y; }

void turn_back(CurveNode& n) {
  n.along = {-n.along.x, -n.along.y};
  n.amplitude_rate = -n.amplitude_rate, n.parameter_rate = -n.parameter_rate;
}

// A position moved towards another up to where its x or y is that of a border.
PlanePoint up_to(PlanePoint a, PlanePoint p, double share) {
  return {a.x + share * (p.x - a.x), a.y + share * (p.y - a.y)};
}

bool changes_sign(double a, double b) { return (a > 0) != (b > 0); }

// Where the cubic of y over x through two nodes turns, as a share of the way; its slope is a parabola that changes its sign.
double turning_place(const CurveNode& a, const CurveNode& b) {
  const double apart = b.at.x - a.at.x, p = a.along.y / a.along.x * apart,
               q = b.along.y / b.along.x * apart;
  const double bend = 3 * (p + q) - 6 * (b.at.y - a.at.y), slope = q - p - bend;
  const double root = std::sqrt(slope * slope - 4 * bend * p);
  const double t = -2 * p / (slope + (slope > 0 ? root : -root)),
               other = -(slope + (slope > 0 ? root : -root)) / (2 * bend);
  for (const double place : {t, other})
    if (place > 0 && place < 1) return place;
  return a.rise / (a.rise - b.rise);
}

}  // namespace

ForcePlane::Value WaveCurve::value(PlanePoint p, const WarmStart* guess, double accuracy,
                                   const SolvedPoint* near) const {
  ForcePlane::Value v = plane_.at(p, guess, accuracy, near);
  zones_ += v.zones();
  if (zones_ > kRules.most_zones) v.wave.in_amplitude.wave.status = PointStatus::unresolved;
  return v;
}

PlanePoint WaveCurve::step_of(const ForcePlane::Value& v, Correction correction) const {
  switch (correction) {
    case Correction::at_its_y: return {-v.excess / v.in_x, 0};
    case Correction::at_its_x: return {0, -v.excess / v.in_y};
    case Correction::across: break;
  }
  const double share = -v.excess / (v.in_x * v.in_x + v.in_y * v.in_y);
  return {share * v.in_x, share * v.in_y};
}

// Newton's method from a predicted wave to the curve.
// @param reach    largest distance from the prediction
// @param settled  last step, which is not solved again
// @param first    becomes how far the first step leads
std::optional<CurveNode> WaveCurve::corrected(PlanePoint p, const WarmStart* guess,
                                              Correction correction, double reach, double settled,
                                              double& first, const SolvedPoint* near) const {
  const PlanePoint predicted = p;
  const bool exact = plane_.continued() == Continued::voltage && correction != Correction::at_its_y;
  if (exact) correction = Correction::at_its_x;
  WarmStart from;
  ForcePlane::Value v;
  for (int i = 0; i < kRules.most_tries; ++i) {
    v = value(p, guess, steps_.states, near);
    if (!v.ok()) return {};
    const PlanePoint step = step_of(v, correction), next{p.x + step.x, p.y + step.y};
    const double size = std::hypot(step.x, step.y);
    if (i == 0) first = size;
    if (!(distance(predicted, next) <= reach)) return {};
    if (exact || size <= settled) return plane_.node(std::move(v), p, step);
    from = moved(v.start(), v.wave.states, std::exp(next.x) - std::exp(p.x),
                 plane_.rate(p.y) * step.y);
    guess = &from, near = &v.wave.solved, p = next;
  }
  return {};
}

std::optional<CurveNode> WaveCurve::solve_at(PlanePoint near, const WarmStart* guess) const {
  double off = 0;
  return corrected(near, guess, Correction::at_its_y, kRules.straight, kRules.extremum, off,
                   nullptr);
}

double WaveCurve::settled_on(double length) const {
  return std::fmin(steps_.settled, kRules.settled_share * length);
}

std::optional<CurveNode> WaveCurve::at_amplitude(double x, const WarmStart* guess) const {
  double off = 0;
  if (plane_.waves().has_static_excess()) guess = nullptr;
  auto n = corrected({x, 0}, guess, Correction::at_its_x, HUGE_VAL, 0, off, nullptr);
  if (n && n->along.x < 0) turn_back(*n);
  return n;
}

double WaveCurve::longest(const CurveNode& from) const {
  if (std::fabs(from.along.y) < kRules.steep) return steps_.steep;
  const bool brakes = plane_.continued() == Continued::speed && from.solved.numbers.torque < 0;
  return brakes ? 2 * steps_.longest : steps_.longest;
}

// The next wave of a curve, a step from its last one, or on the border if that is nearer.
std::optional<CurveNode> WaveCurve::take_step(const Vector<CurveNode>& curve, double length,
                                              double& off, bool& lands) const {
  const CurveNode& a = curve.back();
  const CurveNode* before = curve.size() > 1 ? &a - 1 : nullptr;
  const double t = before ? 1 + length / (a.place - before->place) : 0;
  const bool bends = before && t <= 3;
  PlanePoint p{a.at.x + length * a.along.x, a.at.y + length * a.along.y};
  if (bends) p = cubic(*before, a, t);
  const WarmStart start = bends ? start_between(*before, a, t) : a.start;
  Correction correction = Correction::across;
  const auto land = [&](double share, Correction on_border) {
    p = up_to(a.at, p, share), correction = on_border, lands = true;
  };
  lands = false;
  if (p.y > range_.high.y) land((range_.high.y - a.at.y) / (p.y - a.at.y), Correction::at_its_y);
  if (p.y < range_.low.y) land((range_.low.y - a.at.y) / (p.y - a.at.y), Correction::at_its_y);
  if (p.x > range_.high.x) land((range_.high.x - a.at.x) / (p.x - a.at.x), Correction::at_its_x);
  if (p.x < range_.low.x) land((range_.low.x - a.at.x) / (p.x - a.at.x), Correction::at_its_x);
  const double reach = std::fmax(kRules.straight * length, kRules.corner);
  return corrected(p, &start, correction, reach, settled_on(length), off, &a.solved);
}

// The tangent turns little from node to node but at a corner. Continued in voltage, amplitudes rise.
bool WaveCurve::goes_back(const CurveNode& from, const CurveNode& to) const {
  if (plane_.continued() == Continued::voltage) return to.along.x < 0;
  const double turn = dot(from.along, to.along);
  if (std::fabs(turn) >= kRules.turn) return turn < 0;
  return dot(to.along, {to.at.x - from.at.x, to.at.y - from.at.y}) < 0;
}

Vector<CurveNode> WaveCurve::follow(const CurveNode& from, bool upward, const Stop& stop) const {
  Vector<CurveNode> curve{from};
  if (changes_sign(from.along.y, upward ? 1 : -1)) turn_back(curve.front());
  curve.front().place = 0;
  double length = std::fmin(longest(from), kRules.first_step);
  const auto closes = [&curve](const CurveNode& n) {
    const CurveNode& begin = curve.front();
    const double last = n.place - curve.end()[-2].place;
    return n.place > 4 * last && dot(n.along, begin.along) > kRules.turn &&
           distance(n.at, begin.at) <= 2 * last &&
           dot({begin.at.x - n.at.x, begin.at.y - n.at.y}, n.along) <= 0;
  };
  while (static_cast<int>(curve.size()) < kRules.most_nodes) {
    double off = 0;
    bool lands = false;
    std::optional<CurveNode> next = take_step(curve, length, off, lands);
    const CurveNode& last = curve.back();
    if (next && goes_back(last, *next)) turn_back(*next);
    const bool bends = next && dot(next->along, last.along) < kRules.turn;
    if (!next || (bends && length > kRules.corner)) {
      length *= 0.5;
      if (length >= kRules.shortest) continue;
      curve.back().jump = true;
      break;
    }
    add(curve, std::move(*next));
    if (lands || (stop && stop(curve))) break;
    if (closes(curve.back())) {
      curve.push_back(curve.front());
      curve.back().place = curve.end()[-2].place;
      break;
    }
    length = std::fmin(longest(curve.back()),
                       length * std::clamp(std::cbrt(steps_.settled / off), 0.5, 2.0));
  }
  return curve;
}

bool WaveCurve::may_turn(const CurveNode& a, const CurveNode& b) const {
  const bool steep = plane_.continued() == Continued::voltage ||
                     std::fmin(std::fabs(a.along.y), std::fabs(b.along.y)) < kRules.steep;
  return steep && hides_folds(a, b);
}

std::optional<CurveNode> WaveCurve::halfway(const CurveNode& a, const CurveNode& b) const {
  double off = 0;
  if (plane_.continued() == Continued::voltage) {
    const WarmStart start = start_between(a, b, 0.5);
    return at_amplitude(0.5 * (a.at.x + b.at.x), &start);
  }
  const double apart = distance(a.at, b.at);
  return corrected(cubic(a, b, 0.5), &a.start, Correction::across, kRules.straight * apart,
                   settled_on(apart), off, &a.solved);
}

void WaveCurve::add(Vector<CurveNode>& curve, CurveNode next, int depth) const {
  const double apart = distance(curve.back().at, next.at);
  if (apart > kRules.shortest && depth < kRules.hidden_folds && may_turn(curve.back(), next)) {
    if (auto middle = halfway(curve.back(), next)) {
      if (goes_back(curve.back(), *middle)) turn_back(*middle);
      add(curve, std::move(*middle), depth + 1);
      add(curve, std::move(next), depth + 1);
      return;
    }
  }
  append(curve, std::move(next));
}

void WaveCurve::append(Vector<CurveNode>& curve, CurveNode next) const {
  next.place = curve.back().place + distance(curve.back().at, next.at);
  if (changes_sign(curve.back().rise, next.rise) && !curve.back().fold) {
    if (auto turn = fold(curve.back(), next)) {
      put_fold(curve, std::move(*turn), std::move(next));
      return;
    }
    (std::fabs(curve.back().rise) < std::fabs(next.rise) ? curve.back() : next).fold = true;
  }
  curve.push_back(std::move(next));
}

// A fold at or beyond one of the two nodes, whose slopes are off by what Newton's last step has moved them, takes its place.
void WaveCurve::put_fold(Vector<CurveNode>& curve, CurveNode fold, CurveNode next) const {
  const double t = (fold.at.x - curve.back().at.x) / (next.at.x - curve.back().at.x);
  if (t <= 0 && curve.size() > 1) fold.jump = curve.back().jump, curve.pop_back();
  if (goes_back(curve.back(), fold)) turn_back(fold);
  fold.place = curve.back().place + distance(curve.back().at, fold.at);
  next.place = fold.place + distance(fold.at, next.at);
  curve.push_back(std::move(fold));
  if (t < 1) curve.push_back(std::move(next));
}

// The wave of an amplitude, near a fold, where the parameter moves with the square of the amplitude.
// @param settled  last step of y, which is not solved again
std::optional<CurveNode> WaveCurve::on_curve(PlanePoint p, const WarmStart& start,
                                             double settled) const {
  WarmStart from = start;
  const bool exact = plane_.continued() == Continued::voltage;
  const double states = std::fmin(kRules.slope_states, kRules.settled_share * settled);
  for (int i = 0; i < kRules.most_tries; ++i) {
    ForcePlane::Value v = value(p, &from, exact ? kRules.slope_states : states);
    if (!v.ok()) return {};
    const PlanePoint step = step_of(v, Correction::at_its_x);
    if (!std::isfinite(step.y)) return {};  // on a plateau H does not depend on the speed
    if (exact || std::fabs(step.y) <= settled) return plane_.node(std::move(v), p, step);
    from = moved(v.start(), v.wave.states, 0, plane_.rate(p.y) * step.y);
    p.y += step.y;
  }
  return {};
}

// Inverse interpolation for H_A = 0 along the curve, halving where it leaves the two nodes. At a kink of H, where H_A jumps past zero, both sides
// close in on it.
std::optional<CurveNode> WaveCurve::fold(const CurveNode& a, const CurveNode& b) const {
  const bool exact = plane_.continued() == Continued::voltage;
  double low = a.at.x, high = b.at.x, rise_low = a.rise, rise_high = b.rise;
  if (!exact && !enclose(a, b, low, high, rise_low, rise_high)) return {};
  InverseInterpolation zero(1, 0);
  zero.add(high, rise_high), zero.add(low, rise_low);
  double x = 0.5 * (low + high);
  if (low == a.at.x && high == b.at.x) x = low + turning_place(a, b) * (high - low);
  double last = high - low, last_before = last;
  double y = cubic(a, b, std::clamp((x - a.at.x) / (b.at.x - a.at.x), 0.0, 1.0)).y;
  WarmStart start = a.start;
  std::optional<CurveNode> n;
  double width = std::fabs(high - low);
  for (int i = 0; i < kRules.most_tries; ++i) {
    // A wave off the curve by a small share of the step leads on as well.
    auto here = on_curve({x, y}, start, std::fmax(kRules.fold, kRules.settled_share * last * last));
    if (!here) return {};
    n = std::move(here);
    (changes_sign(n->rise, a.rise) ? high : low) = x;
    start = n->start;
    n->fold = true;
    if (n->rise == 0) return n;
    if (std::fabs(high - low) <= (exact ? kRules.kink : kRules.root)) {
      if (n->at.x > std::fmin(low, high))
        n = on_curve({std::fmin(low, high), n->at.y}, start, kRules.fold);
      if (n) n->fold = true, n->beyond_kink = std::exp(std::fmax(low, high));
      return n;
    }
    zero.add(x, n->rise);
    double next = zero.zero();
    // Where H jumps, interpolation leads to it from one side only.
    const bool stuck = i % 4 == 3 && std::fabs(high - low) > 0.5 * width;
    const bool inside = !stuck && (next - low) * (next - high) < 0;
    if (!inside) next = 0.5 * (low + high);
    if (i % 4 == 3) width = std::fabs(high - low);
    const double step = next - x;
    // The error of a secant is the product of the last two steps, but for a factor; at a kink it stays a share of the last one.
    const bool smooth = std::fabs(step) <= kRules.secants * std::fabs(last * last_before);
    const bool flat = !exact || std::fabs(n->rise) <= kRules.doubtful;
    if (inside && smooth && flat && std::fabs(step) <= kRules.short_secant &&
        std::fabs(step * last) <= (exact ? kRules.extremum : kRules.last_secants)) {
      if (!exact) {
        n = on_curve({next, n->at.y + 0.5 * step * n->along.y / n->along.x}, start, kRules.fold);
        if (n) n->fold = true;
        return n;
      }
      n->at.x = next, n->amplitude = std::exp(next);
      n->at.y += 0.5 * n->rise * step, n->parameter = plane_.parameter(n->at.y);
      return n;
    }
    y = n->at.y + (inside ? 0.5 : 1) * step * n->along.y / n->along.x;
    last_before = last, last = step, x = next;
  }
  return {};
}

// Widens the interval of a fold where the slope of a node is so small that it may have the wrong sign.
bool WaveCurve::enclose(const CurveNode& a, const CurveNode& b, double& low, double& high,
                        double& rise_low, double& rise_high) const {
  const double apart = b.at.x - a.at.x;
  const auto widened = [&](const CurveNode& n, double& end, double away) {
    if (std::fabs(n.rise) > kRules.doubtful) return true;
    for (int i = 0; i < kRules.most_halvings; ++i, end += away, away *= 2) {
      const auto here = on_curve({end, n.at.y}, n.start, kRules.fold);
      if (!here) return false;
      (&n == &a ? rise_low : rise_high) = here->rise;
      if (!changes_sign(here->rise, n.rise)) return true;
      (&n == &a ? high : low) = end;
    }
    return false;
  };
  const double nearby = kRules.speed.settled * (apart > 0 ? 1 : -1);
  return widened(a, low, -nearby) && widened(b, high, nearby);
}

Vector<CurveNode> WaveCurve::through(const CurveNode& wave) const {
  Vector<CurveNode> ahead = follow(wave, true);
  const bool closed = ahead.size() > 2 && ahead.back().at.x == ahead.front().at.x &&
                      ahead.back().at.y == ahead.front().at.y;
  if (closed || wave.at.y <= range_.low.y) return ahead;
  Vector<CurveNode> curve = follow(wave, false);
  const double length = curve.back().place;
  std::reverse(curve.begin(), curve.end());
  for (CurveNode& n : curve) turn_back(n), n.place = length - n.place;
  for (CurveNode& n : ahead) n.place += length;
  curve.insert(curve.end(), std::make_move_iterator(ahead.begin() + 1),
               std::make_move_iterator(ahead.end()));
  return curve;
}

std::optional<CurveNode> WaveCurve::between(const CurveNode& a, const CurveNode& b,
                                            double y) const {
  const double t = place_of(a, b, y);
  double low = std::fmin(a.at.x, b.at.x), high = std::fmax(a.at.x, b.at.x);
  for (const double share : {0.25, 0.5, 0.75}) {
    const double x = cubic(a, b, share).x;
    low = std::fmin(low, x), high = std::fmax(high, x);
  }
  // A kink between them leaves the cubic by as much as may be left of a step. Beyond a fold lies another wave.
  const double slack = std::fmax(high - low, kRules.speed.settled) + kRules.kink;
  const auto is_fold_at = [&](double x) {
    return (a.fold && a.at.x == x) || (b.fold && b.at.x == x);
  };
  return root({cubic(a, b, t).x, y}, start_between(a, b, t), (t < 0.5 ? a : b).solved,
              a.rise + b.rise > 0, low - (is_fold_at(low) ? 0 : slack),
              high + (is_fold_at(high) ? 0 : slack));
}

std::optional<CurveNode> WaveCurve::solve_to_rounding(const CurveNode& n) const {
  return root(n.at, n.start, n.solved, n.rise > 0, n.at.x - kRules.speed.settled,
              n.at.x + kRules.speed.settled);
}

// Newton's method in a bracket, at the y of a point.
std::optional<CurveNode> WaveCurve::root(PlanePoint p, WarmStart start, const SolvedPoint& near,
                                         bool rises, double low, double high) const {
  for (int i = 0; i < kRules.most_tries; ++i) {
    ForcePlane::Value v = value(p, &start, 0, &near);
    if (!v.ok()) return {};
    if (std::fabs(v.excess) <= kRules.rounding) return plane_.node(std::move(v), p, {0, 0});
    double next = p.x - v.excess / v.in_x;
    if (std::fabs(next - p.x) <= kRules.root) return plane_.node(std::move(v), p, {next - p.x, 0});
    ((v.excess < 0) == rises ? low : high) = p.x;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (high - low <= kRules.root)
      return std::fabs(v.excess) <= kRules.noise
                 ? std::optional(plane_.node(std::move(v), p, {0, 0}))
                 : std::nullopt;
    start = moved(v.start(), v.wave.states, std::exp(next) - std::exp(p.x));
    p.x = next;
  }
  return {};
}

}  // namespace twum::inline v0_1::core
