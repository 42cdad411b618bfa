// SPDX-License-Identifier: Apache-2.0
#include "curve/search.hpp"

#include "curve/jumping_peak.hpp"
#include "curve/smooth_peak.hpp"

#include <algorithm>

namespace twum::inline v0_1::core {
namespace {

constexpr double kSameTorque = 1e-14;  // what rounding leaves of the plateau's torque
constexpr double kTypedTorque =
    1e-12;  // rounding of a torque typed, such as the stall torque itself

// Position after the last node that carries a torque; 0 if none does.
std::size_t after_last(const Vector<CurvePoint>& nodes, double torque) {
  std::size_t k = nodes.size() - 1;
  while (k > 0 && !(nodes[k - 1].torque >= torque)) --k;
  return k;
}

}  // namespace

// A curve that begins above rest says why there is no such point.
double CurveSearch::stall_torque() {
  return points_.curve().begin() > 0 ? points_.answered(0).torque : scan_.first().torque;
}

Peak CurveSearch::peak_power() {
  if (!scan_.drives()) return {0, 0, PeakKind::rest};
  return peak(Goal::power);
}

Peak CurveSearch::working_peak() {
  scan_.require_drive();
  return peak_power();
}

Peak CurveSearch::efficiency_peak(Goal goal) {
  if (!points_.curve().has_input()) throw SearchFailure{MetricStatus::undefined};
  return peak(goal);
}

Peak CurveSearch::highest_seen(Goal goal) {
  std::optional<Peak>& kept = peaks_[static_cast<std::size_t>(goal)];
  if (!kept) kept = found_peak(goal);
  return *kept;
}

Peak CurveSearch::peak(Goal goal) {
  scan_.require_drive();
  // Beside a gap the peak is not told, so that it need not be found.
  const bool is_known = peaks_[static_cast<std::size_t>(goal)].has_value();
  if (!is_known && !begins_highest(goal) && points_.curve().may_jump() &&
      JumpingPeakSearch(goal, points_, crossings_, stretches_).is_beside_gap())
    throw SearchFailure{MetricStatus::no_periodic_state};
  const Peak seen = highest_seen(goal);
  if (seen.beside_gap) throw SearchFailure{MetricStatus::no_periodic_state};
  return seen;
}

// |T| <= mu F_N r: a motor that stalls on its plateau cannot do better.
bool CurveSearch::begins_highest(Goal goal) {
  return goal == Goal::torque && !points_.curve().has_static_excess() && scan_.starts_on_plateau();
}

Peak CurveSearch::found_peak(Goal goal) {
  scan_.require_drive();
  const Curve& curve = points_.curve();
  const Peak first = GoalCurve(goal, points_).peak_at(scan_.first(), PeakKind::rest);
  if (begins_highest(goal)) return first;
  const Peak found = curve.may_jump()
                         ? JumpingPeakSearch(goal, points_, crossings_, stretches_).find()
                         : SmoothPeakSearch(goal, points_, scan_, crossings_).find();
  const bool no_more = goal == Goal::torque && found.value <= first.value * (1 + kSameTorque);
  return no_more ? Peak{first.speed, first.value, first.kind, found.beside_gap} : found;
}

Crossing CurveSearch::speed_at(double torque) {
  if (torque == 0) return no_load();
  if (!(torque > 0) || !scan_.drives()) throw SearchFailure{MetricStatus::unreachable};
  if (falls_beyond_top(torque)) {
    constexpr Peak kAnywhereBelow{};
    return passes_at_jump(torque) ? no_load() : falls_through(torque, kAnywhereBelow);
  }
  const Peak top = highest_seen(Goal::torque);
  if (!(torque * (1 - kTypedTorque) <= top.value))
    throw SearchFailure{top.beside_gap ? MetricStatus::no_periodic_state
                                       : MetricStatus::unreachable};
  const bool falls_from_first = top.speed == scan_.first().speed;
  if (falls_from_first && scan_.starts_on_plateau() &&
      torque >= scan_.first().torque * (1 - kSameTorque))
    return {plateau_end(), false};
  // From its beginning torque falls; elsewhere it may rise to its largest value, and jump.
  if (torque >= top.value) return {top.speed, !falls_from_first};
  if (passes_at_jump(torque)) return no_load();
  return falls_through(torque, top);
}

// The largest torque lies beside nodes that are worth a look for it. Where the last node that carries the asked torque is beyond
// them, it need not be known.
bool CurveSearch::falls_beyond_top(double torque) {
  const Vector<CurvePoint> nodes = crossings_.working_nodes();
  double most = 0;
  for (const CurvePoint& node : nodes) most = std::max(most, node.torque);
  const std::size_t k = after_last(nodes, torque);
  return k > 0 && nodes[k - 1].torque < CurveStretches::kWorth * most;
}

// Torque may jump past a value where it jumps past zero.
bool CurveSearch::passes_at_jump(double torque) {
  return no_load().slopeless && crossings_.working_nodes().back().torque >= torque;
}

// Where the torque falls through a value below its maximum for the last time.
Crossing CurveSearch::falls_through(double torque, const Peak& top) {
  const Vector<CurvePoint> nodes = nodes_around(torque);
  std::size_t k = after_last(nodes, torque);
  if (k > 0 && nodes[k - 1].speed >= top.speed)
    return crossings_.falls_through(torque, nodes[k - 1], nodes[k]);
  // No node beyond the maximum carries it: it is met between the maximum and the first of them.
  while (k < nodes.size() && nodes[k].speed <= top.speed) ++k;
  const CurvePoint at_top = points_.answered(top.speed);
  if (k < nodes.size() && at_top.torque > torque)
    return crossings_.falls_through(torque, at_top, nodes[k]);
  return {top.speed, true};  // beside a jump
}

// Points up to no-load between which one may look for a torque. Where it may jump up between two nodes that carry less, the
// ends of stretches are among them beyond the last node that carries it.
Vector<CurvePoint> CurveSearch::nodes_around(double torque) {
  const Vector<CurvePoint> nodes = crossings_.working_nodes();
  if (!points_.curve().may_jump()) return nodes;
  const std::size_t from = std::max<std::size_t>(after_last(nodes, torque), 1) - 1;
  Vector<CurvePoint> all(nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(from) + 1);
  for (std::size_t k = from + 1; k < nodes.size(); ++k) {
    if (std::max(nodes[k - 1].torque, nodes[k].torque) < CurveStretches::kWorth * torque) {
      all.push_back(nodes[k]);
      continue;
    }
    for (const Stretch& stretch : stretches_.between(nodes[k - 1], nodes[k]))
      for (const CurvePoint& each : {stretch.first, stretch.last})
        if (each.ok() && each.speed > all.back().speed) all.push_back(each);
  }
  return all;
}

}  // namespace twum::inline v0_1::core
