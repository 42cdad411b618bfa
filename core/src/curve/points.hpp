// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "curve/curve.hpp"

#include <optional>

namespace twum::inline v0_1::core {

/// Points and slopes of one curve. Those that several searches need are found once.
class CurvePoints {
 public:
  explicit CurvePoints(const Curve& curve) : curve_(curve) {}

  const Curve& curve() const { return curve_; }

  CurvePoint at(double speed) const { return curve_.point(speed, nullptr, 0); }
  /// @throws SearchFailure if the point has no answer
  CurvePoint answered(double speed) const;
  /// One that other searches come back to, with its status.
  /// @throws SearchFailure if there are too many
  const CurvePoint& stored_point(double speed);
  /// @throws SearchFailure if the point has no answer
  CurveSlope slope(double speed, const WarmStart* guess = nullptr);

 private:
  const Curve& curve_;
  Vector<CurveSlope> slopes_;
  Map<double, CurvePoint> kept_;  // by speed
};

/// A walk along the curve: each point begins with what the two before it say.
class Walk {
 public:
  explicit Walk(CurvePoints& points) : points_(points) {}

  /// Takes a known point for the last one met.
  void pass(double speed, const WarmStart& start);
  void pass(const CurvePoint& point) { pass(point.speed, point.start); }

  /// @param accuracy  of the periodic state, as find_periodic_state()
  CurvePoint at(double speed, double accuracy = 0);
  /// @throws SearchFailure if the point has no answer
  CurvePoint answered(double speed);
  CurveSlope slope(double speed);

 private:
  struct Known {
    double speed;
    WarmStart start;
  };
  const WarmStart* extrapolated_start(double speed);

  CurvePoints& points_;
  std::optional<Known> before_, last_;
  WarmStart guess_{};
};

/// Points of one search that halves intervals again and again. Speeds without a periodic state, each followed up to its
/// limit, may lie close together, and so may jumps, of which far from any motor rounding makes as many as there are
/// numbers: then the search ends with a status.
class Halving {
 public:
  explicit Halving(CurvePoints& points) : points_(points) {}

  /// @throws SearchFailure if the search takes too long
  const CurvePoint& at(double speed);
  /// One slice alone. @throws SearchFailure if the search takes too long
  std::optional<std::uint64_t> slice_at(double speed, std::size_t slice);

 private:
  void lose(long zones, MetricStatus status);

  CurvePoints& points_;
  long lost_{0};  // zones followed in vain by this search
};

}  // namespace twum::inline v0_1::core
