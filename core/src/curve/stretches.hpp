// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "curve/points.hpp"

#include <twum/base/function_ref.hpp>

#include <utility>

namespace twum::inline v0_1::core {

/// A part of the curve with the same sequence of zones and without a jump, if there were not too many to tell apart; or a
/// part without a periodic state.
struct Stretch {
  CurvePoint first, last;
  Vector<double> inside;  ///< speeds between, so close that torque is steady between neighbours
};

/// What stretches between two points tell whose ends are known to a thousandth of the way.
struct Glimpse {
  bool worthy{false};  ///< they are worth exact ends, or there are too many to tell
  bool gap{false};     ///< one of them is a gap, see is_gap()
};

/// Where torque may jump, as with mu_0 > mu, searches take the curve apart into stretches over which it does not, once for all of
/// them.
class CurveStretches {
 public:
  static constexpr double kInset =
      1e-7;  ///< share of a stretch at its ends, which stand for themselves
  static constexpr double kWorth = 0.7;  ///< share of a value above which jumps nearby may pass it
  static constexpr double kGap =
      1e-4;  ///< of the crest speed: fewer speeds without a periodic state, as at a jump, hide nothing

  explicit CurveStretches(CurvePoints& points) : points_(points), halving_(points) {}

  /// Whether speeds between two without an answer may hide something. Single ones without a periodic state, as at a jump, hide
  /// nothing.
  bool is_gap(double low, double high) const;

  /// What lies between two points, cut where the sequence of zones changes and where the torque jumps.
  /// @throws SearchFailure if the search takes too long
  const Vector<Stretch>& between(const CurvePoint& low, const CurvePoint& end);
  /// A look before that: exact ends take four times as many points.
  /// @param worth  whether a point is worth exact ends
  Glimpse glimpse(const CurvePoint& low, const CurvePoint& end,
                  FunctionRef<bool(const CurvePoint&)> worth);

 private:
  Vector<Stretch> found_between(const CurvePoint& low, const CurvePoint& end);
  Vector<CurvePoint> steady_between(const CurvePoint& low, const CurvePoint& high);
  bool is_steady(const CurvePoint& low, const CurvePoint& high);
  std::pair<double, double> change_of_slices(const CurvePoint& low, const CurvePoint& end);
  std::pair<CurvePoint, CurvePoint> stretch_end(const CurvePoint& low, const CurvePoint& end);
  CurvePoint past_jump(const CurvePoint& end, double inside);
  bool are_neighbours(double low, double high) const;
  bool meet_at_gap(const CurvePoint& left, const CurvePoint& right) const;

  CurvePoints& points_;
  Halving halving_;
  Map<std::pair<double, double>, Vector<Stretch>> known_;  // by the speeds of both points
};

}  // namespace twum::inline v0_1::core
