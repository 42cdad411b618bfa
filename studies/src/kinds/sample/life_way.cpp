// SPDX-License-Identifier: Apache-2.0
#include "kinds/sample/life_way.hpp"

#include <twum/base/no_value.hpp>
#include <twum/motion/free_life.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace twum::inline v0_1::studies {
namespace {

using motion::FreeLife;
using motion::WornTrackPoint;

LifeWay even_way(const MotorDesign& design, const std::optional<LoadPoint>& load,
                 std::uint64_t points) {
  LifeWay way;
  way.life = load ? life(design, *load) : life(design);
  if (way.life.status != MetricStatus::ok) return way;
  std::vector<double> depths;
  for (std::uint64_t i = 0; i < points; ++i)
    depths.push_back(way.life.depth * static_cast<double>(i) / static_cast<double>(points - 1));
  for (const WearPoint& wear : wear_course(design, load, depths))
    way.points.push_back({wear, worn_motor(design, wear.depth), wear.depth});
  return way;
}

WayPoint on_way(const MotorDesign& design, const TrackWear& track, const WornTrackPoint& at) {
  MotorDesign worn = worn_motor(design, at.depths);
  const WearPoint wear{.depth = at.depth,
                       .seconds = at.seconds,
                       .revolutions = at.revolutions,
                       .rate = track.mean(at.rates),
                       .thickness = worn.layer.thickness,
                       .preload = worn.preload,
                       .contact_temperature = kNoValue};
  return {wear, std::move(worn), *std::ranges::max_element(at.depths)};
}

// Steps crowd where much happens: every so many of them, with the first and the last.
std::vector<const WornTrackPoint*> chosen(const std::vector<WornTrackPoint>& steps,
                                          std::uint64_t points) {
  const std::size_t count = std::min<std::size_t>(steps.size(), points);
  std::vector<const WornTrackPoint*> list;
  for (std::size_t i = 0; i < count; ++i)
    list.push_back(&steps[count < 2 ? 0 : i * (steps.size() - 1) / (count - 1)]);
  return list;
}

// Of the first load of the mission.
LifeResult::TrackState state_of(const FreeLife& life, const WornTrackPoint& at) {
  LifeResult::TrackState state{.seconds = at.seconds};
  if (at.loads.empty()) return state;
  const TrackLoad& load = at.loads.front();
  state.speed = load.speed, state.torque = load.torque;
  state.friction_power = load.friction_power;
  for (std::size_t j = 0; j < life.nodes.size(); ++j)
    state.nodes.push_back(
        {life.nodes[j].radius, at.depths[j], load.pressures[j], load.loads[j] / at.preload});
  return state;
}

bool is_worn_in(const WornTrackPoint& at) {
  constexpr double kAlike = 0.01;
  const auto [least, most] = std::ranges::minmax(at.rates);
  return most - least <= kAlike * most;
}

LifeResult::FreeTrack track_of(const FreeLife& life) {
  LifeResult::FreeTrack track;
  track.largest_share = life.largest_share;
  track.fresh = state_of(life, life.points.front()), track.last = state_of(life, life.last);
  const auto uneven = std::find_if_not(life.points.rbegin(), life.points.rend(), is_worn_in);
  if (uneven != life.points.rbegin()) track.run_in = state_of(life, *uneven.base());
  return track;
}

LifeWay free_way(const MotorDesign& design, const std::optional<LoadPoint>& load,
                 std::uint64_t points) {
  const FreeLife found = motion::free_life(design, load);
  LifeWay way;
  way.life = {found.status,     found.end,          found.limit,
              found.last.depth, found.last.seconds, found.last.revolutions};
  way.stability = found.stability;
  if (is_endless(found.status))
    way.life.seconds = way.life.revolutions = std::numeric_limits<double>::infinity();
  const bool told =
      found.status == MetricStatus::ok || found.status == MetricStatus::wear_localizes;
  if (!told) return way;
  const TrackWear track(design, load);
  for (const WornTrackPoint* point : chosen(found.points, points))
    way.points.push_back(on_way(design, track, *point));
  way.free = track_of(found);
  return way;
}

}  // namespace

LifeWay way_of_life(const MotorDesign& design, const std::optional<LoadPoint>& load,
                    std::uint64_t points) {
  return wears_freely(design) ? free_way(design, load, points) : even_way(design, load, points);
}

void require_way_of_life(const MotorDesign& design, const std::optional<LoadPoint>& load) {
  if (wears_freely(design)) motion::require_free_life(design, load);
}

}  // namespace twum::inline v0_1::studies
