// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "drive/wave_curve.hpp"

#include <array>
#include <utility>
#include <vector>

namespace twum::inline v0_1::core {

/// A part of a curve of waves over the speed in which each speed has one wave, and H rises with the amplitude.
struct BranchPiece {
  Vector<CurveNode> nodes;  ///< by rising speed
  bool running;
  bool dead;     ///< that of a stator which the rotor clamps; a single wave at rest is both
  int curve{0};  ///< number of the curve that it is a part of

  double lowest() const { return nodes.front().parameter; }
  double highest() const { return nodes.back().parameter; }
  bool is(bool running_one) const { return running_one ? running : dead; }
  /// The ripple of a real motor's speed is larger than other pieces.
  bool is_wide() const { return highest() - lowest() > kRules.narrowest * highest(); }
  bool covers(double speed) const { return speed >= lowest() && speed <= highest(); }
  /// The neighbouring nodes about a speed.
  std::pair<const CurveNode*, const CurveNode*> around(double speed) const;
  /// The nodes beside two neighbours, null where they have other zones than both.
  std::array<const CurveNode*, 2> outer_neighbours(const CurveNode& a, const CurveNode& b) const;
};

}  // namespace twum::inline v0_1::core
