// SPDX-License-Identifier: Apache-2.0
#include "curve/smooth_peak.hpp"

#include <algorithm>

namespace twum::inline v0_1::core {
namespace {

constexpr double kRippled =
    0.95;  // share of the best node, of intervals that ripples may hide a hump in
constexpr double kBesideFold = 1e-9;  // of the crest speed

}  // namespace

SmoothPeakSearch::SmoothPeakSearch(Goal goal, CurvePoints& points, CurveScan& scan,
                                   CurveCrossings& crossings)
    : goal_(goal, points),
      points_(points),
      scan_(scan),
      crossings_(crossings),
      nodes_(with_ripples(goal == Goal::power ? crossings.powerful_nodes()
                                              : crossings.working_nodes())) {}

Peak SmoothPeakSearch::find() {
  const std::size_t top = goal_.highest(nodes_);
  Peak best = peak_beside(top);
  const auto consider = [&](const Peak& peak) {
    if (peak.value > best.value) best = peak;
  };
  for (std::size_t k = 0; k + 1 < nodes_.size(); ++k) {
    const bool hump = (k == 0 || value(k) >= value(k - 1)) && value(k) >= value(k + 1);
    if (hump && k != top && value(k) >= GoalCurve::kNearly * value(top)) consider(peak_beside(k));
  }
  if (goal_.goal() != Goal::torque && plateau_may_top(best.value)) {
    const CurvePoint end = points_.answered(crossings_.plateau_end());
    consider({end.speed, goal_.value(end), PeakKind::plateau_end});
  }
  best.beside_gap = is_beside_gap(best.value);
  return best;
}

// Single speeds without a periodic state hide nothing.
bool SmoothPeakSearch::is_beside_gap(double best) {
  const double aside = CurveStretches::kGap * points_.curve().crest();
  const auto lacks = [&](double speed) {
    return points_.at(speed).status == MetricStatus::no_periodic_state;
  };
  for (const double gap : scan_.gaps()) {
    const auto next = std::find_if(nodes_.begin(), nodes_.end(),
                                   [&](const CurvePoint& n) { return n.speed > gap; });
    if (next == nodes_.begin() || next == nodes_.end()) continue;
    const double around = std::max(goal_.value(next[-1]), goal_.value(*next));
    if (around >= CurveStretches::kWorth * best && lacks(gap - aside) && lacks(gap + aside))
      return true;
  }
  return false;
}

// More nodes where a ripple between two of them may be the highest.
Vector<CurvePoint> SmoothPeakSearch::with_ripples(Vector<CurvePoint> nodes) {
  if (!scan_.ripples()) return nodes;
  const double worth = kRippled * goal_.value(nodes[goal_.highest(nodes)]);
  Vector<CurvePoint> all(nodes.begin(), nodes.begin() + 1);
  for (std::size_t k = 1; k < nodes.size(); ++k) {
    const CurvePoint &low = nodes[k - 1], &high = nodes[k];
    const bool worthy = !high.plateau && std::max(goal_.value(low), goal_.value(high)) >= worth;
    if (worthy) {
      const Vector<CurvePoint>& more = scan_.rippled(low, high);
      all.insert(all.end(), more.begin(), more.end());
    }
    all.push_back(high);
  }
  return all;
}

// Where a speed beside it has no answer, as without damping, the node stands for the maximum.
Peak SmoothPeakSearch::peak_beside(std::size_t top) {
  try {
    return sharp_peak(top);
  } catch (const SearchFailure&) {
    return goal_.peak_at(points_.answered(nodes_[top].speed), PeakKind::kink);
  }
}

// A curve that begins above rest begins at a fold, with an infinite slope: that is taken just beyond.
double SmoothPeakSearch::sloped_place(std::size_t k) const {
  const double speed = nodes_[k].speed, begin = points_.curve().begin();
  return begin > 0 && speed == begin ? speed + kBesideFold * points_.curve().crest() : speed;
}

Peak SmoothPeakSearch::sharp_peak(std::size_t top) {
  if (top > 0 && top + 1 < nodes_.size()) {
    const std::optional<Peak> near = peak_near(top);
    if (near && near->value >= value(top) * (1 - 1e3 * CurveScan::kAccuracy)) return *near;
  }
  const Peak at_node = goal_.peak_at(points_.answered(nodes_[top].speed), PeakKind::smooth);
  if (nodes_.size() == 1) return at_node;
  const bool rises = goal_.at(sloped_place(top)).slope > 0;
  if (!rises && top == 0) return at_node;
  if (rises && top + 1 == nodes_.size()) return at_node;
  const std::size_t from = rises ? top : top - 1;
  const std::optional<Peak> inside = goal_.peak_between(sloped_place(from), nodes_[from + 1].speed);
  if (!inside || !(inside->value >= at_node.value)) return at_node;
  if (inside->kind == PeakKind::kink && crossings_.leaves_plateau_at(inside->speed))
    return {crossings_.plateau_end(), inside->value, PeakKind::plateau_end};
  return *inside;
}

// The zero of the slope by inverse interpolation, from where the nodes about `top` have their maximum;
// nothing if that does not settle at once between its neighbours, as at a kink.
std::optional<Peak> SmoothPeakSearch::peak_near(std::size_t top) {
  const CurvePoint &a = nodes_[top - 1], &b = nodes_[top], &c = nodes_[top + 1];
  Interpolant curve = curve_about(top);
  double speed = likely_peak(curve, b.speed);
  Walk walk(points_);
  walk.pass(b.speed < speed ? c : a);
  walk.pass(b);
  InverseInterpolation line(points_.curve().crest(), 1e-13);
  for (int i = 0; i < 8; ++i) {
    if (!(speed > a.speed && speed < c.speed)) return {};
    const Sloped s = goal_.sloped(walk.slope(speed));
    if (s.slope == 0) return Peak{speed, s.value, PeakKind::smooth};
    line.add(speed, s.slope);
    if (i == 0) curve.bend(speed, s.slope);
    const Interpolant::Value p = curve.at(speed);
    const std::optional<double> early = line.zero_of_two(p.curvature, p.jerk);
    const double step = i == 0 ? -s.slope / p.curvature : early.value_or(line.zero()) - speed;
    if (!(step * s.slope > 0)) return {};  // not a maximum
    speed += step;
    if (early || line.has_converged())
      return Peak{speed, s.value + 0.5 * s.slope * step, PeakKind::smooth};
  }
  return {};
}

// The polynomial through the nodes about `top`, those of the plateau left out.
Interpolant SmoothPeakSearch::curve_about(std::size_t top) const {
  Interpolant curve;
  for (std::size_t k = top < 2 ? 0 : top - 2; k < std::min(top + 3, nodes_.size()); ++k) {
    if (!nodes_[k].plateau) curve.add(nodes_[k].speed, value(k));
  }
  return curve;
}

// Where it has its maximum near a speed.
double SmoothPeakSearch::likely_peak(const Interpolant& curve, double speed) {
  for (int i = 0; i < 4; ++i) {
    const Interpolant::Value p = curve.at(speed);
    speed -= p.slope / p.curvature;
  }
  return speed;
}

// Power and efficiency may have their maximum at the plateau's end, a kink, wherever the best node is.
bool SmoothPeakSearch::plateau_may_top(double best) {
  const auto beyond =
      std::find_if(nodes_.begin(), nodes_.end(), [](const CurvePoint& n) { return !n.plateau; });
  if (beyond == nodes_.begin() || beyond == nodes_.end()) return false;
  CurvePoint most = *beyond;
  most.torque = nodes_.front().torque;
  most.input = std::min(beyond[-1].input, beyond->input);
  return goal_.value(most) > best;
}

}  // namespace twum::inline v0_1::core
