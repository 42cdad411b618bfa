// SPDX-License-Identifier: Apache-2.0
#include "wear_ends.hpp"

#include <twum/base/no_value.hpp>
#include <twum/base/scalar_search.hpp>
#include <twum/core/metrics.hpp>

#include <algorithm>
#include <cmath>

namespace twum::motion {
namespace {

constexpr double kMostShare = 3;  // of its even share, beyond which the wear localizes
constexpr double kWithin = 1e-6;  // of the depth at which lining or preload is gone

using DepthsAt = std::function<std::vector<double>(double time)>;

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

// In its unit; NaN where the worn motor has no value for it.
double WearEnds::margin_of_until(std::size_t limit, std::span<const double> depths) const {
  const WearLimit& one = design_.wear->until[limit];
  const MetricValue found = evaluate(Motor(worn_motor(design_, depths)), one.request);
  constexpr double kNoLimit = std::numeric_limits<double>::infinity();
  if (is_endless(found.status)) return std::isinf(one.upper) ? kNoLimit : -kNoLimit;
  if (found.status != MetricStatus::ok) return kNoValue;
  return std::fmin(found.value - one.lower, one.upper - found.value);
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

// Where a margin reaches zero, or the last time at which the limit has a value.
double WearEnds::root(const WearEnd& limit, const DepthsAt& depths_at, double good, double bad) {
  const auto f = [&](double time) { return margin(limit, depths_at(time)); };
  double at_bad = f(bad);
  while (std::isnan(at_bad) && bad - good > 1e-12 * bad) {
    const double middle = 0.5 * (good + bad), there = f(middle);
    if (there >= 0)
      good = middle;
    else
      bad = middle, at_bad = there;
  }
  const double at_good = f(good);
  // What rounding of the dense output leaves of a margin at the step's beginning.
  if (std::isnan(at_bad) || !(at_good > 0)) return good;
  return closed_in("the end of a life", f, Bracket{good, bad, at_good, at_bad}, 40).nearest();
}

std::optional<WearEndAt> WearEnds::within(const DepthsAt& depths_at, double begin, double end,
                                          bool beyond_localization) {
  std::optional<WearEndAt> first;
  const std::vector<double> depths = depths_at(end);
  for (const WearEnd& limit : limits_) {
    if (limit.localizes && beyond_localization) continue;
    if (margin(limit, depths) >= 0) continue;
    const double time = root(limit, depths_at, begin, end);
    if (!first || time < first->time) first = {limit, time};
  }
  return first;
}

}  // namespace twum::motion
