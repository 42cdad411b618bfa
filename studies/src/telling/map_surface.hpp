// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "telling/contours.hpp"

#include <twum/studies/map_result.hpp>

#include <cstddef>
#include <vector>

namespace twum::inline v0_1::studies::telling {

/// A column of a map between its points; internal. Within the envelope it is linear in the torque at each speed, and between
/// two speeds along lines of the same share of the largest torque, so that it ends where the envelope does.
class MapSurface {
 public:
  MapSurface(const MapResult& map, const MapResult::Member& member, std::size_t column);

  double largest_speed() const { return columns_.empty() ? 0 : columns_.back().speed; }
  /// NaN beyond the envelope, and beside points that are not held.
  double at(double speed, double torque) const;
  /// The values on a fine grid over the whole map.
  ValueGrid fine(const MapResult& map) const;

 private:
  struct Column {
    double speed, largest;  // torque
    std::vector<double> torques, values;
  };
  static double on(const Column& column, double share);

  std::vector<Column> columns_;  // speeds at which the drive holds a torque
};

}  // namespace twum::inline v0_1::studies::telling
