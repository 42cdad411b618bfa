// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "curve/crossings.hpp"
#include "curve/goal.hpp"
#include "curve/stretches.hpp"

#include <cstddef>
#include <optional>

namespace twum::inline v0_1::core {

/// Search for the largest value of a goal where torque does not jump: humps of the nodes, made exact by their slopes.
class SmoothPeakSearch {
 public:
  SmoothPeakSearch(Goal goal, CurvePoints& points, CurveScan& scan, CurveCrossings& crossings);

  Peak find();

 private:
  Vector<CurvePoint> with_ripples(Vector<CurvePoint> nodes);
  bool is_beside_gap(double best);
  double value(std::size_t k) const { return goal_.value(nodes_[k]); }
  Peak peak_beside(std::size_t top);
  double sloped_place(std::size_t k) const;
  Peak sharp_peak(std::size_t top);
  std::optional<Peak> peak_near(std::size_t top);
  Interpolant curve_about(std::size_t top) const;
  static double likely_peak(const Interpolant& curve, double speed);
  bool plateau_may_top(double best);

  GoalCurve goal_;
  CurvePoints& points_;
  CurveScan& scan_;
  CurveCrossings& crossings_;
  Vector<CurvePoint> nodes_;  // up to no-load
};

}  // namespace twum::inline v0_1::core
