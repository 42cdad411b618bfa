// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "performance/motor_model.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace twum::performance {

/// What a slice's zones tell of those beside it.
struct SliceZones {
  std::uint64_t signature;  ///< fingerprint of their sequence
  double shortest;          ///< length of the shortest [rad]
};

/// The zones of the slice at a radius of the track [m].
using ZonesAt = std::function<SliceZones(double radius)>;

/// Where zones appear or vanish along the track (W4.4), as splits of the pieces that touch: to about 1e-6 of a piece, and to
/// 2e-4 where a zone begins at the edge of the contact.
/// @param at_nodes  zones of the motor's slices, in their order
std::vector<Split> zone_splits(const DrivenMotor<double>& motor,
                               const std::vector<SliceZones>& at_nodes, const ZonesAt& zones_at);

}  // namespace twum::performance
