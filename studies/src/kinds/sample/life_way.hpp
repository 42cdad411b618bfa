// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/life.hpp>
#include <twum/core/load.hpp>
#include <twum/core/motor_design.hpp>
#include <twum/core/worn_in.hpp>
#include <twum/studies/life_result.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace twum::inline v0_1::studies {

/// A motor on the way through its life.
struct WayPoint {
  WearPoint wear;     ///< with a free profile depth and rate are means over the track
  MotorDesign motor;  ///< as it is worn
  double deepest;     ///< worn depth at the deepest radius [m]
};

/// The life of a motor, by the profile of its wear.
struct LifeWay {
  Life life{};
  std::vector<WayPoint> points{};               ///< from new to the end; none without a life
  std::optional<WearStability> stability{};     ///< with a free profile
  std::optional<LifeResult::FreeTrack> free{};  ///< likewise
};

/// @param points  how many, at least 2: at even depths, or of the steps of a free profile as many as there are
/// @throws InputError as life(), and with a free profile as motion::free_life()
LifeWay way_of_life(const MotorDesign& design, const std::optional<LoadPoint>& load,
                    std::uint64_t points);

/// Checks that way_of_life() can serve this motor, without computing the life. @throws InputError as way_of_life()
void require_way_of_life(const MotorDesign& design, const std::optional<LoadPoint>& load);

}  // namespace twum::inline v0_1::studies
