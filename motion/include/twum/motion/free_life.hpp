// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/life.hpp>
#include <twum/core/load.hpp>
#include <twum/core/metric_value.hpp>
#include <twum/core/motor_design.hpp>
#include <twum/core/track_wear.hpp>

#include <limits>
#include <optional>
#include <vector>

namespace twum::inline v0_1::motion {

/// A track of which each radius wears by itself, at one time.
struct WornTrackPoint {
  double seconds{0};               ///< since it was new
  double revolutions{0};           ///< likewise [1]
  double depth{0};                 ///< u, mean over the area [m]
  double preload{0};               ///< F_N - k_F u [N]
  std::vector<double> depths{};    ///< e_j of each node [m]
  std::vector<double> rates{};     ///< and how fast it wears [m/s]
  std::vector<TrackLoad> loads{};  ///< what each load of the mission does at the nodes
};

/// How a life with a free profile is followed.
struct FreeLifeOptions {
  std::vector<double> output_times{};  ///< rising [s]; empty: all steps of the integrator
  double longest{std::numeric_limits<double>::infinity()};  ///< goes no further [s]
  /// Goes on where the wear localizes, though the model is not valid there.
  bool beyond_localization{false};
  /// Of the depths, in parts of how deep the wave presses into the new layer.
  double tolerance{1e-8};
};

/// The life of a motor of which each radius of the track wears by itself (V3.3).
struct FreeLife {
  /// ok; does_not_wear; wear_localizes: a node carries more than three times its even share, so that there is no life; not_converged:
  /// the integrator failed; else why the new motor has no such point
  MetricStatus status{MetricStatus::ok};
  /// Of the new motor (V3.7); uneven is the status wears-unevenly.
  WearStability stability{WearStability::unknown};
  EndOfLife end{EndOfLife::none};  ///< what ends it; none where it goes on at the longest time
  std::size_t limit{0};            ///< which of Wear::until, if one ended it
  /// Largest load of a node at the end, in parts of its even share: the larger of what it carries in the new motor and what it would
  /// carry of an even pressure [1].
  double largest_share{1};
  std::vector<TrackNode> nodes{};        ///< of the track
  std::vector<WornTrackPoint> points{};  ///< from new on, up to the end
  WornTrackPoint last{};                 ///< where the life ends, or where it was left
  long steps{0};                         ///< of the integrator
};

/// Follows the depths of a track (V3.1 to V3.3) by backward differentiation with an exact Jacobian. Limits are watched at the steps, and
/// their roots found within the step; the depth limit holds at the deepest node. Some hundred steps of ten operating points each for
/// each load, and one evaluation of each limit of Wear::until a step. A given amplitude takes some hundredths of a second, a motor under
/// a voltage seconds.
/// @param load  none: the operation of the design
/// @throws InputError as TrackWear(), and without an integrator
FreeLife free_life(const MotorDesign& design, const std::optional<LoadPoint>& load,
                   const FreeLifeOptions& options = {});

/// Checks that free_life() can serve this motor, without computing the life. @throws InputError as free_life()
void require_free_life(const MotorDesign& design, const std::optional<LoadPoint>& load);

}  // namespace twum::inline v0_1::motion
