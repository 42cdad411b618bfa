// SPDX-License-Identifier: Apache-2.0
#include "wear_ends.hpp"

#include <twum/base/no_value.hpp>
#include <twum/base/scalar_search.hpp>
#include <twum/core/metrics.hpp>

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::motion {
namespace {

constexpr double kMostShare = 3;  // of its even share, beyond which the wear localizes
constexpr double kWithin = 1e-6;  // of the depth at which lining or preload is gone

}  // namespace

WearEnds::WearEnds(const MotorDesign& design, TrackWear& track, const TrackRates& first)
    : design_(design), track_(track) {
  const auto& nodes = track.nodes();
  double area = 0;
  for (const TrackNode& node : nodes) area += node.radius * node.width;
  for (const TrackLoad& load : first.loads) {
    std::vector<double>& even = even_.emplace_back();
    for (std::size_t j = 0; j < nodes.size(); ++j)
      even.push_back(
          std::fmax(load.loads[j], design.preload * nodes[j].radius * nodes[j].width / area));
  }
  const Wear& wear = *design.wear;
  limits_.push_back({EndOfLife::load_lost});
  for (std::size_t j = 0; j < wear.until.size(); ++j) limits_.push_back({EndOfLife::limit, j});
  if (wear.depth_limit) limits_.push_back({EndOfLife::depth_limit});
  if (wear.preload_spring > 0) limits_.push_back({EndOfLife::preload_gone});
  if (std::isfinite(track.worn_through())) limits_.push_back({EndOfLife::worn_through});
  limits_.push_back({EndOfLife::none, 0, true});
}

double WearEnds::largest_share(const std::vector<TrackLoad>& loads) const {
  double largest = 0;
  for (std::size_t i = 0; i < loads.size(); ++i)
    for (std::size_t j = 0; j < loads[i].loads.size(); ++j)
      largest = std::fmax(largest, loads[i].loads[j] / even_[i][j]);
  return largest;
}

double WearEnds::margin_of_until(std::size_t limit, std::span<const double> depths) const {
  const WearLimit& one = design_.wear->until[limit];
  return margin_of(one, evaluate(Motor(worn_motor(design_, depths)), one.request));
}

double WearEnds::margin(const WearEnd& limit, std::span<const double> depths) {
  const double deepest = *std::ranges::max_element(depths);
  if (limit.localizes) return kMostShare - largest_share(track_.at(depths).loads);
  switch (limit.end) {
    case EndOfLife::load_lost: return track_.at(depths).status == MetricStatus::ok ? 1 : kNoValue;
    case EndOfLife::limit: return margin_of_until(limit.limit, depths);
    case EndOfLife::depth_limit: return *design_.wear->depth_limit - deepest;
    case EndOfLife::preload_gone:
      return (1 - kWithin) * design_.preload - design_.wear->preload_spring * track_.mean(depths);
    default: return (1 - kWithin) * track_.worn_through() - deepest;
  }
}

std::optional<WearEnd> WearEnds::first_broken(std::span<const double> depths) {
  for (const WearEnd& limit : limits_)
    if (!(margin(limit, depths) >= 0)) return limit;
  return {};
}

std::optional<WearEndAt> WearEnds::within(const DepthsAt& depths_at, double begin, double end,
                                          bool beyond_localization) {
  std::optional<WearEndAt> first;
  const std::vector<double> depths = depths_at(end);
  for (const WearEnd& limit : limits_) {
    if (limit.localizes && beyond_localization) continue;
    if (margin(limit, depths) >= 0) continue;
    const auto margin_at = [&](double time) { return margin(limit, depths_at(time)); };
    const double time = zero_or_last_value("the end of a life", margin_at, begin, end, 40);
    if (!first || time < first->time) first = {limit, time};
  }
  return first;
}

}  // namespace twum::inline v0_1::motion
