// SPDX-License-Identifier: Apache-2.0
#include "contact/lane_laps.hpp"

#include "contact/short_slip.hpp"

#include <twum/base/error.hpp>

#include <algorithm>
#include <array>

namespace twum::inline v0_1::contact {
namespace {

void put(ContactNumbers<LaneArray>& n, int lane, const ContactNumbers<double>& contact) {
  n.inertia.v[lane] = contact.inertia, n.damping.v[lane] = contact.damping;
  n.stick_rate.v[lane] = contact.stick_rate, n.speed_ratio.v[lane] = contact.speed_ratio;
  n.half_angle.v[lane] = contact.half_angle, n.peak.v[lane] = contact.peak;
  n.kinetic.v[lane] = contact.kinetic, n.threshold.v[lane] = contact.threshold;
  n.edge.sin.v[lane] = contact.edge.sin, n.edge.cos.v[lane] = contact.edge.cos;
  n.edge.versine.v[lane] = contact.edge.versine;
}

void take(Lap<double>& lap, const LaneBatch& batch, int lane) {
  const ContactMeans<LaneArray>& m = batch.means;
  lap.means = {m.traction.v[lane],   m.stator_power.v[lane], m.friction_power.v[lane],
               m.layer_loss.v[lane], m.stick_length.v[lane], m.reactive_force.v[lane]};
  lap.exit = {batch.exit.e.v[lane], batch.exit.rate.v[lane]};
  double rest = 2 * batch.contacts.half_angle.v[lane];
  for (const LaneBatch::Zone& z : batch.zones) {
    if (z.has.v[lane] == 0) continue;
    const auto zone = static_cast<ZoneState>(static_cast<int>(z.zone.v[lane]));
    const auto side = static_cast<float>(z.side.v[lane]);
    const double length = z.length.v[lane];
    lap.sequence.ends[lap.sequence.count++] = {length, side, zone};
    lap.itinerary = marked(lap.itinerary, mark_of(zone));
    lap.shortest = std::min({lap.shortest, length, rest});
    lap.next.zone = zone;
    if (!(length < rest)) break;  // it lasts to the exit
    rest -= length;
  }
  lap.zones = lap.sequence.count;
  lap.first = lap.sequence.ends[0].zone;
  lap.one_slip = lap.zones == 1;
}

}  // namespace

std::span<LaneCode* const> lane_codes() {
#if defined(__x86_64__)
  static constexpr std::array kCodes{&run_lanes_baseline, &run_lanes_avx2, &run_lanes_avx512};
  static const std::size_t count = __builtin_cpu_supports("avx512dq") ? 3
                                   : __builtin_cpu_supports("avx2")   ? 2
                                                                      : 1;
#else
  static constexpr std::array kCodes{&run_lanes_baseline};
  static constexpr std::size_t count = 1;
#endif
  return std::span(kCodes).first(count);
}

bool goes_in_step(const ContactNumbers<double>& n, const LayerMotion<double>& layer) {
  return layer.serves_lanes() && enters_at_rest(n, layer) && !(n.threshold > n.kinetic) &&
         !is_delicate(n, layer);
}

void run_in_step(const LayerMotion<double>& layer, std::span<LaneLap> laps, LaneCode& code) {
  TWUM_ASSERT(laps.size() <= kLanes);
  if (laps.empty()) return;
  LaneBatch batch;
  for (int lane = 0; lane < kLanes; ++lane) {
    const std::size_t lap = std::min(static_cast<std::size_t>(lane), laps.size() - 1);
    put(batch.contacts, lane, *laps[lap].contact);
  }
  code(layer, batch);
  for (std::size_t lane = 0; lane < laps.size(); ++lane) {
    laps[lane].found = batch.found.v[lane] != 0;
    if (laps[lane].found) take(*laps[lane].lap, batch, static_cast<int>(lane));
  }
}

}  // namespace twum::inline v0_1::contact
