// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "drive/driven_wave.hpp"

#include <array>

namespace twum::inline v0_1::core {

/// Position in the plane in which a curve of waves is followed: ln A, and the parameter in parts of its scale.
struct PlanePoint {
  double x, y;
};

/// A wave of a curve, from which its neighbours are found.
struct CurveNode {
  double place{0};   ///< length of the curve up to here
  PlanePoint at;     ///< where
  PlanePoint along;  ///< tangent, of length 1
  double amplitude;  ///< [m]
  double parameter;  ///< what is continued: speed or frequency [rad/s], or force of the voltage [N]
  double amplitude_rate, parameter_rate;  ///< their derivatives in the place
  double rise;                            ///< A H_A / H; 0 at a fold
  double force_slope;                     ///< H_A [N/m]
  bool behind;            ///< R <= 0: the wave lags by more than a quarter of a turn
  bool grows;             ///< a disturbance of the wave does not die away
  bool fold{false};       ///< the curve turns here
  bool jump{false};       ///< the curve begins or ends here because H jumps
  double beyond_kink{0};  ///< at a fold where H_A jumps past zero: amplitude of the other side
  SolvedPoint solved{};   ///< under nearly this wave; its numbers are to first order in the rest
  WarmStart start{};      ///< the layer's state at entry under this wave
  MovingStates states{};  ///< how that moves

  bool stable() const { return rise > 0 && !grows; }
};

/// They have as many slices, all with states that move.
bool same_slices(const CurveNode& a, const CurveNode& b);

/// Where the search for a wave between two nodes begins.
struct CurveGuess {
  double amplitude, force_slope;
  WarmStart start;
  MovingStates states;  ///< empty where the nodes do not agree on the slices
  double left{1};       ///< share of the guess's error that a step of Newton's method may leave
};

/// Position on Hermite's cubic through two nodes, t = 0 at the first and 1 at the second; beyond 1 it is extrapolated.
PlanePoint cubic(const CurveNode& a, const CurveNode& b, double t);

/// Where that cubic has a y between those of both ends; the curve must not turn between them.
double place_of(const CurveNode& a, const CurveNode& b, double y);

/// The cubic has a fold or two between nodes that both rise or both fall.
bool hides_folds(const CurveNode& a, const CurveNode& b);

/// The layer's state there, by Hermite's cubic again, as its slopes are known.
WarmStart start_between(const CurveNode& a, const CurveNode& b, double t);

/// Both cubics, and for all else the polynomial through the two nodes and those beside them.
/// @param beside  the next nodes on both sides, if they have the same zones and slices; else null
CurveGuess guess_between(const CurveNode& a, const CurveNode& b, double t,
                         const std::array<const CurveNode*, 2>& beside);

/// The start under an amplitude that is larger by `step`, and a parameter that is larger by `turn`.
WarmStart moved(const WarmStart& start, const MovingStates& states, double step, double turn = 0);
PointNumbers<double> moved(const PointNumbers<contact::MotionDual>& n, double step, double turn);

}  // namespace twum::inline v0_1::core
