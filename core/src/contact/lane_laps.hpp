// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/lane_batch.hpp"
#include "contact/lap.hpp"

#include <span>

namespace twum::inline v0_1::contact {

/// What this processor can run, the widest last. The numbers are the same for all, to the last bit.
std::span<LaneCode* const> lane_codes();

/// True if the lap of a contact can be made in step with others: the layer comes to it at rest, with inertia, and mu_0 = mu.
bool goes_in_step(const ContactNumbers<double>& numbers, const LayerMotion<double>& layer);

/// A contact and its lap.
struct LaneLap {
  const ContactNumbers<double>* contact;
  Lap<double>* lap;   ///< not yet run
  bool found{false};  ///< false: it still has to be
};

/// Laps from rest of up to kLanes contacts that one layer goes through in step: the search of run_lap() in lanes, with the
/// simpler of its bounds. A lap of which few samples do not prove that no zone ends earlier is not found.
void run_in_step(const LayerMotion<double>& layer, std::span<LaneLap> laps,
                 LaneCode& code = *lane_codes().back());

}  // namespace twum::inline v0_1::contact
