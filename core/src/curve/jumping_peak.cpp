// SPDX-License-Identifier: Apache-2.0
#include "curve/jumping_peak.hpp"

#include <algorithm>

namespace twum::inline v0_1::core {

JumpingPeakSearch::JumpingPeakSearch(Goal goal, CurvePoints& points, CurveCrossings& crossings,
                                     CurveStretches& stretches)
    : goal_(goal, points),
      points_(points),
      crossings_(crossings),
      stretches_(stretches),
      nodes_(crossings.working_nodes()),
      best_(goal_.peak_at(nodes_[goal_.highest(nodes_)], PeakKind::kink)),
      worth_(CurveStretches::kWorth * best_.value) {}

Peak JumpingPeakSearch::find() {
  bool beside_gap = false;
  for (std::size_t k = 0; k + 1 < nodes_.size(); ++k) {
    if (higher_end(k) < worth_) continue;
    const Glimpse seen = glimpse(k);
    beside_gap = beside_gap || seen.gap;
    if (higher_end(k) < nearly() && !seen.worthy) continue;
    for (const Stretch& stretch : stretches_.between(nodes_[k], nodes_[k + 1])) {
      beside_gap = beside_gap || (!stretch.first.ok() &&
                                  stretches_.is_gap(stretch.first.speed, stretch.last.speed));
      look_at(stretch);
    }
  }
  best_.beside_gap = beside_gap;
  return with_plateau_named(best_);
}

bool JumpingPeakSearch::is_beside_gap() {
  for (std::size_t k = 0; k + 1 < nodes_.size(); ++k)
    if (higher_end(k) >= worth_ && glimpse(k).gap) return true;
  return false;
}

double JumpingPeakSearch::higher_end(std::size_t k) const {
  return std::max(goal_.value(nodes_[k]), goal_.value(nodes_[k + 1]));
}

double JumpingPeakSearch::nearly() const { return GoalCurve::kNearly * best_.value; }

Glimpse JumpingPeakSearch::glimpse(std::size_t k) {
  return stretches_.glimpse(nodes_[k], nodes_[k + 1], [this](const CurvePoint& p) {
    return p.ok() && goal_.value(p) >= nearly();
  });
}

void JumpingPeakSearch::look_at(const Stretch& stretch) {
  const auto consider = [this](const Peak& peak) {
    if (peak.value > best_.value) best_ = peak;
  };
  const auto consider_end = [&](const CurvePoint& end) {
    if (end.ok()) consider({end.speed, goal_.value(end), PeakKind::kink});
  };
  consider_end(stretch.first);
  for (const Peak& inside : peaks_inside(stretch, nearly())) consider(inside);
  consider_end(stretch.last);
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
