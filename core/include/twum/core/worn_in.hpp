// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/load.hpp>
#include <twum/core/metric_value.hpp>
#include <twum/core/motor_design.hpp>

#include <vector>

namespace twum::inline v0_1 {

/// Whether a track that wears by Archard's law at each radius stays even (V3.7).
enum class WearStability : unsigned char {
  even,  ///< differences of depth decay
  uneven,  ///< a radius that is a little less worn takes over the load: its wear falls as its load rises
  unknown  ///< one slice, no such point, or a point without derivatives
};

/// A short word such as "wears-unevenly"; static lifetime.
const char* to_string(WearStability stability) noexcept;

/// Of the new motor under a load, at its speed and its wave.
/// @throws InputError for an impossible motor
WearStability wear_stability(const MotorDesign& design, const LoadPoint& load);

/// A slice of a track that is worn in.
struct WornInSlice {
  double radius;  ///< rho [m]
  double load;    ///< its part of the preload [N]
  double depth;   ///< of the layer under the crest there [m]
  double
      worn;  ///< worn depth beyond that of the least worn slice, of an even rotor that runs in [m]
};

/// The state after run-in: every radius wears at one rate (V3.4).
struct WornIn {
  MetricStatus status{
      MetricStatus::ok};  ///< not ok: no such state was found, or it is not stable (V3.7)
  double speed{0};        ///< of the rotor [rad/s]
  double torque{0};       ///< [N m]
  double intensity{0};    ///< friction power per area, the same at every radius [W/m^2]
  std::vector<WornInSlice>
      slices{};  ///< Gauss nodes of the whole track: |radial_slices|, 16 for `auto`
};

/// Newton's method on the loads of the slices and the speed, each slice a motor of its own with exact derivatives. Of a motor with a
/// given amplitude; status undefined for one under a voltage, with one slice, or for a load that the drive holds.
/// @throws InputError for an impossible motor
WornIn worn_in(const MotorDesign& design, const LoadPoint& load);

}  // namespace twum::inline v0_1
