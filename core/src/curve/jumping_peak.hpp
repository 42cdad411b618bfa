// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "curve/crossings.hpp"
#include "curve/goal.hpp"
#include "curve/stretches.hpp"

#include <optional>

namespace twum::inline v0_1::core {

/// Search for the largest value of a goal where torque may jump: every stretch with the same sequence of zones, or without
/// a periodic state, is taken by itself, its ends located by halving.
class JumpingPeakSearch {
 public:
  JumpingPeakSearch(Goal goal, CurvePoints& points, CurveCrossings& crossings,
                    CurveStretches& stretches);

  Peak find();
  /// The peak is surely beside a gap: seen at a glimpse.
  bool is_beside_gap();

 private:
  double higher_end(std::size_t k) const;  // of the interval from node k
  double nearly() const;
  Glimpse glimpse(std::size_t k);
  void look_at(const Stretch& stretch);
  bool may_have_peaks(const Stretch& stretch) const;
  Vector<Peak> peaks_inside(const Stretch& stretch, double worth);
  std::optional<Peak> peak_between(double low, double high);
  Peak with_plateau_named(Peak peak);

  GoalCurve goal_;
  CurvePoints& points_;
  CurveCrossings& crossings_;
  CurveStretches& stretches_;
  Vector<CurvePoint> nodes_;
  Peak best_;
  double worth_;
};

}  // namespace twum::inline v0_1::core
