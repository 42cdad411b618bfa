// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "curve/crossings.hpp"
#include "curve/goal.hpp"
#include "curve/stretches.hpp"

#include <array>
#include <optional>

namespace twum::inline v0_1::core {

/// What is searched for over a torque-speed curve. Each result is found once and kept.
class CurveSearch {
 public:
  /// @param curve  has to outlive the search
  explicit CurveSearch(const Curve& curve)
      : points_(curve), scan_(points_), crossings_(points_, scan_), stretches_(points_) {}
  CurveSearch(const CurveSearch&) = delete;
  CurveSearch& operator=(const CurveSearch&) = delete;

  double stall_torque();                                     ///< (T7.12)
  Crossing no_load() { return crossings_.no_load(); }        ///< (T7.14)
  double plateau_end() { return crossings_.plateau_end(); }  ///< (T7.17)
  Peak max_torque() { return peak(Goal::torque); }           ///< (T7.13)
  Peak peak_power();                                         ///< (T7.16)
  Peak working_peak();  ///< the same, of a motor that has a stall torque
  Peak max_efficiency() { return efficiency_peak(Goal::efficiency); }  ///< (T7.18)
  /// Of the power at the terminals, which has to be known.
  Peak max_overall_efficiency() { return efficiency_peak(Goal::overall_efficiency); }
  Crossing speed_at(double torque);  ///< (T7.15)

 private:
  Peak highest_seen(Goal goal);
  Peak peak(Goal goal);  // the highest seen, unless speeds without a state may hide a higher one
  Peak efficiency_peak(Goal goal);
  Peak found_peak(Goal goal);
  bool begins_highest(Goal goal);
  Vector<CurvePoint> nodes_around(double torque);
  bool falls_beyond_top(double torque);
  bool passes_at_jump(double torque);
  Crossing falls_through(double torque, const Peak& top);

  CurvePoints points_;
  CurveScan scan_;
  CurveCrossings crossings_;
  CurveStretches stretches_;
  std::array<std::optional<Peak>, kGoals> peaks_;
};

}  // namespace twum::inline v0_1::core
