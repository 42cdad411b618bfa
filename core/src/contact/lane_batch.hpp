// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/contact_numbers.hpp"
#include "contact/layer_motion.hpp"

#include <array>

namespace twum::inline v0_1::contact {

/// What a processor adds and multiplies at once: 1, 2, 4 or 8 numbers. One at a time is what tests compare the others with.
enum class LaneWidth : unsigned char { single, baseline, avx2, avx512 };

inline constexpr int kLanes = 8;

/// A page has to be small: there every contact goes alone.
#if defined(__wasm__)
inline constexpr bool kHasLanes = false;
#else
inline constexpr bool kHasLanes = true;
#endif

/// Numbers in memory, one for each lane.
struct LaneArray {
  alignas(8 * kLanes) double v[kLanes];
};

/// Contacts of one layer and their laps from rest, one in each lane: what code for one width passes to code for all.
struct LaneBatch {
  static constexpr int kRounds = 4;  ///< of slip and stick: as many zones as a ZoneSequence holds

  /// A zone of those lanes that have it: the numbers of a ZoneSequence::End, kNoZero included.
  struct Zone {
    LaneArray has, zone, length, side;
  };

  ContactNumbers<LaneArray> contacts;
  LaneArray found;  ///< 1 where there is a lap; the others are to go alone
  ContactMeans<LaneArray> means;
  LayerState<LaneArray> exit;
  std::array<Zone, 2 * kRounds> zones;  ///< slip and stick in turn
};

/// Fills the batch. One for each width, compiled for it.
using LaneCode = void(const LayerMotion<double>& layer, LaneBatch& batch);
LaneCode run_lanes_baseline, run_lanes_avx2, run_lanes_avx512;

}  // namespace twum::inline v0_1::contact
