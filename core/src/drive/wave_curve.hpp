// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "drive/force_plane.hpp"
#include "drive/rules.hpp"

#include <functional>
#include <optional>

namespace twum::inline v0_1::core {

/// A part of the plane, by its corners.
struct PlaneRange {
  PlanePoint low, high;
};

/// Continuation of the curve of waves H = Theta u_0 in a plane, by its length. A step goes along the cubic through the last two waves,
/// at first along the tangent (D2.11); Newton's method leads back to the curve across it; and how far it led chooses the next step. A
/// fold is where the tangent turns, found by its own equation H_A = 0 (D2.8). Where H jumps, the curve ends with what is known on the
/// near side, and is found again on the far side.
class WaveCurve {
 public:
  WaveCurve(const ForcePlane& plane, const PlaneRange& range, const CurveSteps& steps)
      : plane_(plane), range_(range), steps_(steps) {}

  /// The wave near a point at its y.
  std::optional<CurveNode> solve_at(PlanePoint near, const WarmStart* guess = nullptr) const;
  /// Says that a curve has been followed far enough.
  using Stop = std::function<bool(const Vector<CurveNode>&)>;
  /// From a wave on, towards larger or smaller y, to the border of the range, a jump of H, or back to the wave. Folds are nodes.
  Vector<CurveNode> follow(const CurveNode& from, bool upward, const Stop& stop = {}) const;
  /// The whole curve through a wave.
  Vector<CurveNode> through(const CurveNode& wave) const;
  /// The wave of an amplitude; continued in voltage, each has one. A guess is of use with mu_0 = mu only.
  std::optional<CurveNode> at_amplitude(double x, const WarmStart* guess = nullptr) const;
  /// Puts a node at the end of a curve, after the folds between it and the last one.
  void add(Vector<CurveNode>& curve, CurveNode next, int depth = 0) const;
  /// The same where it is known that no two folds hide.
  void append(Vector<CurveNode>& curve, CurveNode next) const;
  std::optional<CurveNode> halfway(const CurveNode& a, const CurveNode& b) const;
  /// The wave between two nodes at a y, by Newton's method in a bracket.
  std::optional<CurveNode> between(const CurveNode& a, const CurveNode& b, double y) const;

  /// A wave that is right to rounding, from one that is nearly so.
  std::optional<CurveNode> solve_to_rounding(const CurveNode& near) const;

  const ForcePlane& plane() const { return plane_; }
  /// Zones followed.
  long zones() const { return zones_; }

 private:
  enum class Correction : unsigned char { across, at_its_y, at_its_x };

  ForcePlane::Value value(PlanePoint p, const WarmStart* guess, double accuracy,
                          const SolvedPoint* near = nullptr) const;
  PlanePoint step_of(const ForcePlane::Value& v, Correction correction) const;
  std::optional<CurveNode> corrected(PlanePoint p, const WarmStart* guess, Correction correction,
                                     double reach, double settled, double& first,
                                     const SolvedPoint* near) const;
  double settled_on(double length) const;
  std::optional<CurveNode> take_step(const Vector<CurveNode>& curve, double length, double& off,
                                     bool& lands) const;
  std::optional<CurveNode> fold(const CurveNode& a, const CurveNode& b) const;
  std::optional<CurveNode> on_curve(PlanePoint p, const WarmStart& start, double settled) const;
  bool enclose(const CurveNode& a, const CurveNode& b, double& low, double& high, double& rise_low,
               double& rise_high) const;
  void put_fold(Vector<CurveNode>& curve, CurveNode fold, CurveNode next) const;
  bool may_turn(const CurveNode& a, const CurveNode& b) const;
  bool goes_back(const CurveNode& from, const CurveNode& to) const;
  double longest(const CurveNode& from) const;
  std::optional<CurveNode> root(PlanePoint p, WarmStart start, const SolvedPoint& near, bool rises,
                                double low, double high) const;

  ForcePlane plane_;
  PlaneRange range_;
  CurveSteps steps_;
  mutable long zones_{0};
};

}  // namespace twum::inline v0_1::core
