// SPDX-License-Identifier: Apache-2.0
#include "curve/jumping_peak.hpp"

#include <algorithm>

namespace twum::inline v0_1::core {

Peak JumpingPeakSearch::find() {
  const Vector<CurvePoint> nodes = crossings_.working_nodes();
  Peak best = goal_.peak_at(nodes[goal_.highest(nodes)], PeakKind::kink);
  const auto consider = [&best](const Peak& peak) {
    if (peak.value > best.value) best = peak;
  };
  const auto consider_end = [&](const CurvePoint& end) {
    if (end.ok()) consider({end.speed, goal_.value(end), PeakKind::kink});
  };
  const double worth = CurveStretches::kWorth * best.value;
  bool beside_gap = false;
  for (std::size_t k = 0; k + 1 < nodes.size(); ++k) {
    if (std::max(goal_.value(nodes[k]), goal_.value(nodes[k + 1])) < worth) continue;
    for (const Stretch& stretch : stretches_.between(nodes[k], nodes[k + 1])) {
      beside_gap = beside_gap || is_gap(stretch);
      consider_end(stretch.first);
      for (const Peak& inside : peaks_inside(stretch, GoalCurve::kNearly * best.value))
        consider(inside);
      consider_end(stretch.last);
    }
  }
  best.beside_gap = beside_gap;
  return with_plateau_named(best);
}

// Single speeds without a periodic state, as at a jump, hide nothing; nor does one with which a stretch begins that was not cut
// further.
bool JumpingPeakSearch::is_gap(const Stretch& stretch) const {
  const auto lacks = [this](double speed) {
    return points_.at(speed).status == MetricStatus::no_periodic_state;
  };
  const double low = stretch.first.speed, high = stretch.last.speed;
  return high - low > CurveStretches::kGap * points_.curve().crest() && lacks(low) &&
         lacks(0.5 * (low + high));
}

// Maxima between neighbouring places of a stretch of which one has the value `worth`. A zone that is just born has
// an end without slope: the ends are a little inside.
Vector<Peak> JumpingPeakSearch::peaks_inside(const Stretch& stretch, double worth) {
  if (!may_have_peaks(stretch)) return {};
  const bool low_all_through =
      stretch.inside.empty() &&
      std::max(goal_.value(stretch.first), goal_.value(stretch.last)) < worth;
  if (low_all_through) return {};
  const double low = stretch.first.speed, high = stretch.last.speed;
  const double inset = CurveStretches::kInset * (high - low);
  Vector<double> places{low + inset};
  places.insert(places.end(), stretch.inside.begin(), stretch.inside.end());
  places.push_back(high - inset);
  Vector<Peak> peaks;
  for (std::size_t k = 1; k < places.size(); ++k) {
    const bool worthy = stretch.inside.empty() ||
                        std::max(goal_.at(places[k - 1]).value, goal_.at(places[k]).value) >= worth;
    if (!worthy) continue;
    if (const std::optional<Peak> peak = peak_between(places[k - 1], places[k]))
      peaks.push_back(*peak);
  }
  return peaks;
}

// At single speeds where a slice jumps, the wave of a motor under a voltage may have no balance: no maximum is there.
std::optional<Peak> JumpingPeakSearch::peak_between(double low, double high) {
  try {
    return goal_.peak_between(low, high);
  } catch (const SearchFailure& failure) {
    if (failure.status != MetricStatus::pulled_out) throw;
    return {};
  }
}

bool JumpingPeakSearch::may_have_peaks(const Stretch& stretch) const {
  const bool level = goal_.goal() == Goal::torque && stretch.first.plateau;
  return stretch.first.ok() && !level && stretch.first.speed < stretch.last.speed;
}

// A peak at the plateau's end by its name. Its speed stays on its side of the jump.
Peak JumpingPeakSearch::with_plateau_named(Peak peak) {
  if (peak.kind == PeakKind::kink && crossings_.leaves_plateau_at(peak.speed))
    peak.kind =
        points_.answered(peak.speed).plateau ? PeakKind::plateau_end : PeakKind::beyond_plateau;
  return peak;
}

}  // namespace twum::inline v0_1::core
