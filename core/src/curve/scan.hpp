// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "curve/points.hpp"

#include <optional>

namespace twum::inline v0_1::core {

/// Points of the curve from its beginning to the first one past no-load: between which of them to look for what is
/// searched. Between two neighbours torque is taken to have no more than one maximum (with mu_0 > mu: one in each stretch
/// with the same sequence of zones).
class CurveScan {
 public:
  static constexpr int kIntervals = 20;      ///< between the beginning and the crest speed
  static constexpr double kAccuracy = 1e-7;  ///< of the points

  explicit CurveScan(CurvePoints& points) : points_(points), walk_(points) {}

  /// The first point that the metrics look at: the beginning of the curve. If the curve begins above rest with a negative torque,
  /// it is where the torque rises through zero. @throws SearchFailure if it has no answer
  const CurvePoint& first();
  /// The torque there is positive.
  bool drives() { return first().torque > 0; }
  /// @throws SearchFailure (undefined) unless it drives
  void require_drive();
  /// The whole contact slips and drives there.
  bool starts_on_plateau() { return first().plateau; }

  /// From the first to the first whose torque is not positive. Those without an answer, as layers without damping or with
  /// mu_0 > mu may have, are left out as long as they do not follow one another.
  /// @throws SearchFailure (undefined) unless it drives, and if there is no end of the curve
  const Vector<CurvePoint>& nodes();

  /// Speeds among the nodes, once these are found, without a periodic state.
  const Vector<double>& gaps() const { return gaps_; }

  /// The torque only falls, and smoothly (E6.7): what is searched on it needs no scan of the whole curve.
  bool falls_smoothly() const;
  /// The node k steps beyond the first, and how many there are below a speed.
  const CurvePoint& on_grid(int k);
  int below(double speed);
  /// A point as good as a node: exact only where its sign is in doubt.
  CurvePoint node(double speed, Walk& walk);
  /// A node's torque is so close to a value that its accuracy counts.
  /// @param excess  of the torque over the value [N m]
  bool in_doubt(double excess) const;

  /// The torque has ripples that the nodes are too far apart to tell.
  bool ripples() const;
  /// Points between a node and the next that tell ripples, as good as the nodes: only good enough to say where to look. Those
  /// without an answer are left out.
  const Vector<CurvePoint>& rippled(const CurvePoint& low, const CurvePoint& high);

 private:
  double step() const;
  CurvePoint checked(CurvePoint node, Walk& walk);
  void run();
  CurvePoint first_that_drives(const CurvePoint& begin);
  CurvePoint just_beyond(double zero);
  void skip_plateau();

  CurvePoints& points_;
  Vector<CurvePoint> nodes_;
  Vector<double> gaps_;
  Map<int, CurvePoint> grid_;  // nodes by steps from the first
  Walk walk_;
  Map<double, Vector<CurvePoint>> rippled_;  // by the speed of the node below
  std::optional<MetricStatus> failure_;
  bool done_{false};
};

}  // namespace twum::inline v0_1::core
