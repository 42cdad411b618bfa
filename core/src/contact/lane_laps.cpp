// SPDX-License-Identifier: Apache-2.0
#include "contact/lane_laps.hpp"

#include "contact/short_slip.hpp"

#include <twum/base/error.hpp>

#include <algorithm>
#include <cmath>

namespace twum::contact {
namespace {

void run(const LayerMotion<double>& layer, LaneBatch& batch, LaneWidth width) {
#if defined(__x86_64__)
  if (width == LaneWidth::avx512) return run_lanes_avx512(layer, batch);
  if (width == LaneWidth::avx2) return run_lanes_avx2(layer, batch);
#endif
  run_lanes_baseline(layer, batch);
}

void put(ContactNumbers<LaneArray>& n, int lane, const ContactNumbers<double>& contact) {
  n.inertia.v[lane] = contact.inertia, n.damping.v[lane] = contact.damping;
  n.stick_rate.v[lane] = contact.stick_rate, n.speed_ratio.v[lane] = contact.speed_ratio;
  n.half_angle.v[lane] = contact.half_angle, n.peak.v[lane] = contact.peak;
  n.kinetic.v[lane] = contact.kinetic, n.static_.v[lane] = contact.static_;
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
    lap.sequence.ends[lap.sequence.count++] = {z.length.v[lane], side, zone};
    lap.itinerary = marked(lap.itinerary, mark_of(zone));
    const double length = std::fmin(z.length.v[lane], rest);
    lap.shortest = std::fmin(lap.shortest, length);
    lap.next.zone = zone;
    rest -= length;
  }
  lap.zones = lap.sequence.count;
  lap.first = lap.sequence.ends[0].zone;
  lap.one_slip = lap.zones == 1;
}

}  // namespace

LaneWidth widest_lanes() {
#if defined(__x86_64__)
  static const LaneWidth widest = __builtin_cpu_supports("avx512dq") ? LaneWidth::avx512
                                  : __builtin_cpu_supports("avx2")   ? LaneWidth::avx2
                                                                     : LaneWidth::baseline;
  return widest;
#else
  return LaneWidth::baseline;
#endif
}

bool goes_in_step(const ContactNumbers<double>& n, const LayerMotion<double>& layer) {
  return layer.serves_lanes() && enters_at_rest(n, layer) && !(n.static_ > n.kinetic) &&
         !is_delicate(n, layer);
}

void run_in_step(const LayerMotion<double>& layer, std::span<LaneLap> laps, LaneWidth width) {
  TWUM_ASSERT(laps.size() <= kLanes);
  if (laps.empty()) return;
  LaneBatch batch;
  for (int lane = 0; lane < kLanes; ++lane) {
    const std::size_t lap = std::min(static_cast<std::size_t>(lane), laps.size() - 1);
    put(batch.contacts, lane, *laps[lap].contact);
  }
  run(layer, batch, width);
  for (std::size_t lane = 0; lane < laps.size(); ++lane) {
    laps[lane].found = batch.found.v[lane] != 0;
    if (laps[lane].found) take(*laps[lane].lap, batch, static_cast<int>(lane));
  }
}

}  // namespace twum::contact
