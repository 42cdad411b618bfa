// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "curve/points.hpp"
#include "curve/speed_roots.hpp"

#include <cstddef>
#include <optional>

namespace twum::inline v0_1::core {

/// How a supremum over speed is reached.
enum class PeakKind : unsigned char {
  smooth,          ///< slope zero inside
  rest,            ///< at speed 0
  plateau_end,     ///< where the torque leaves its plateau
  beyond_plateau,  ///< just beyond, where it jumps to a higher value
  kink  ///< at another kink or jump, or at the end of the curve: the one-sided limit there
};

struct Peak {
  double speed{0}, value{0};
  PeakKind kind{PeakKind::smooth};
  bool beside_gap{
      false};  ///< speeds without a periodic state beside values nearly as good may hide a higher one
};

/// What is to be as large as possible over speed.
enum class Goal : unsigned char { torque, power, efficiency, overall_efficiency };
inline constexpr std::size_t kGoals = 4;

/// A goal along the curve.
class GoalCurve {
 public:
  static constexpr double kNearly =
      0.97;  ///< share of the best point above which another hump may be higher

  GoalCurve(Goal goal, CurvePoints& points) : goal_(goal), points_(points) {}

  Goal goal() const { return goal_; }
  double value(const CurvePoint& p) const {
    return sloped(p.speed, {p.torque, 0}, {is_overall() ? p.electrical_input : p.input, 0}).value;
  }
  /// @throws SearchFailure if the point has no answer
  Sloped at(double speed) const { return sloped(points_.slope(speed)); }
  Sloped sloped(const CurveSlope& s) const {
    return sloped(s.speed, s.torque, is_overall() ? s.electrical_input : s.input);
  }

  /// Position of the highest point, the slowest one of several.
  std::size_t highest(const Vector<CurvePoint>& nodes) const;
  /// A maximum in an interval where the slope goes from + to -; nothing if it does not.
  std::optional<Peak> peak_between(double low, double high) const;
  /// A point that is itself the highest, of this kind unless the curve begins there.
  Peak peak_at(const CurvePoint& p, PeakKind inside) const;

 private:
  bool is_overall() const { return goal_ == Goal::overall_efficiency; }
  // (T7.1), (T7.7) and their slopes.
  Sloped sloped(double speed, const Sloped& torque, const Sloped& input) const {
    if (goal_ == Goal::torque) return torque;
    const Sloped power{torque.value * speed, torque.value + speed * torque.slope};
    if (goal_ == Goal::power) return power;
    return {power.value / input.value,
            (power.slope * input.value - power.value * input.slope) / (input.value * input.value)};
  }
  std::optional<Bracket> slope_bracket(double low, double high) const;

  Goal goal_;
  CurvePoints& points_;
};

}  // namespace twum::inline v0_1::core
