// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "curve/scan.hpp"

#include <optional>

namespace twum::inline v0_1::core {

/// A speed where the torque takes a value.
struct Crossing {
  double speed{0};
  /// It has no slope there to tell how the speed moves: a jump, or a maximum.
  bool slopeless{false};
};

/// Where the torque falls through a value, and where it leaves its plateau. Each is found once and kept.
class CurveCrossings {
 public:
  CurveCrossings(CurvePoints& points, CurveScan& scan) : points_(points), scan_(scan) {}

  Crossing no_load();    ///< (T7.14)
  double plateau_end();  ///< (T7.17)

  /// Points of the scan up to no-load, the last one there.
  Vector<CurvePoint> working_nodes();
  /// Those of them between which the largest power lies: of a torque that falls, the ones at the highest speeds.
  Vector<CurvePoint> powerful_nodes();
  /// Where the torque falls through a value between two points, of which the slower one carries it.
  Crossing falls_through(double torque, const CurvePoint& low, const CurvePoint& high);
  /// True if the curve has a plateau that ends at this speed.
  bool leaves_plateau_at(double speed);

 private:
  std::optional<double> zero_of_falling();
  const Vector<CurvePoint>& all_nodes();
  const Vector<CurvePoint>& powerful_of_falling();
  Vector<CurvePoint> from_no_load_down();
  CurvePoint answered_beside(double speed) const;
  std::optional<double> zero_near(double torque, const CurvePoint& low, const CurvePoint& high);
  double margin_end(double low, double high) const;
  double just_before(double end) const;
  bool on_plateau(double speed) const;
  double last_on_plateau(double low, double high) const;

  CurvePoints& points_;
  CurveScan& scan_;
  std::optional<Crossing> no_load_;
  std::optional<Vector<CurvePoint>> powerful_;  // empty where it is not known which they are
  std::optional<double> plateau_end_;
};

}  // namespace twum::inline v0_1::core
