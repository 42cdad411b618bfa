// SPDX-License-Identifier: Apache-2.0
// Torque with mu_0 > mu may jump: stretches of the curve over which it does not.
#include "performance/curve_search.hpp"

#include <cmath>

namespace twum::performance {
namespace {

constexpr std::size_t kStretches = 8;  // sequences of zones between two nodes
constexpr double kSteady = 1e-4;       // of the holding torque: what a mean slope may leave
constexpr double kJump = 1e-6;  // of the holding torque: more than torque moves in so short a share

}  // namespace

// What lies between two nodes, cut where the sequence of zones changes and where the torque jumps.
std::vector<CurveSearch::Stretch> CurveSearch::stretches(const Node& low, const Node& end) {
  std::vector<Stretch> all;
  std::vector<Node> nodes;
  add_between(low, end, nodes);
  Node before = low;
  Stretch stretch{low, low, {}};
  const auto cut = [&](const Node& left, const Node& right) {
    stretch.last = left;
    all.push_back(stretch);
    stretch = {right, right, {}};
  };
  for (const Node& next : nodes) {
    const bool jump = before.itinerary == next.itinerary && !is_steady(before, next);
    if (jump && all.size() + 1 < kStretches) cut(before, next);
    // Where zones are born, rounding can tell many sequences apart: the rest counts as one stretch.
    while (before.itinerary != next.itinerary && all.size() + 1 < kStretches) {
      const auto [left, right] = stretch_end(before, next);
      cut(left, right);
      before = right;
    }
    if (stretch.first.speed < next.speed && next.speed < end.speed)
      stretch.inside.push_back(next.speed);
    before = next;
  }
  cut(end, end);
  return all;
}

// Nodes from beyond `low` to `high` such that between neighbours with the same zones the torque goes as its slopes say.
void CurveSearch::add_between(const Node& low, const Node& high, std::vector<Node>& nodes) {
  if (low.itinerary == high.itinerary && !is_steady(low, high)) {
    const Node middle = halved(0.5 * (low.speed + high.speed));
    if (low.speed < middle.speed && middle.speed < high.speed) {
      add_between(low, middle, nodes);
      return add_between(middle, high, nodes);
    }
  }
  nodes.push_back(high);
}

// True if the torque's change is that of its mean slope.
bool CurveSearch::is_steady(const Node& low, const Node& high) {
  if (!low.ok() || (low.plateau && high.plateau)) return true;
  const double slope = 0.5 * (torque_slope_at(low.speed).slope + torque_slope_at(high.speed).slope);
  const double rest = high.torque - low.torque - slope * (high.speed - low.speed);
  return std::fabs(rest) <= kSteady * holding_;
}

// Neighbouring speeds between which the sequence of zones that holds at `low` ends.
std::pair<CurveSearch::Node, CurveSearch::Node> CurveSearch::stretch_end(const Node& low,
                                                                         const Node& end) {
  Node left = low, right = end;
  while (right.speed - left.speed > 4e-16 * (crest_ + right.speed)) {
    const Node& middle = halved(0.5 * (left.speed + right.speed));
    if (middle.speed <= left.speed || middle.speed >= right.speed) break;
    (middle.itinerary == low.itinerary ? left : right) = middle;
  }
  return {past_jump(left, left.speed - kInset * (left.speed - low.speed)),
          past_jump(right, right.speed + kInset * (end.speed - right.speed))};
}

// The end of a stretch, or where the torque jumps a hair inside of it: a zone that is just born may grow at once.
CurveSearch::Node CurveSearch::past_jump(const Node& end, double inside) {
  Node past = halved(inside);
  const auto near = [this](const Node& a, const Node& b) {
    return a.itinerary == b.itinerary && std::fabs(a.torque - b.torque) <= kJump * holding_;
  };
  if (past.itinerary != end.itinerary || near(past, end)) return end;
  double before = end.speed;
  while (std::fabs(past.speed - before) > 4e-16 * (crest_ + past.speed)) {
    const Node& middle = halved(0.5 * (before + past.speed));
    if (middle.speed == before || middle.speed == past.speed) break;
    if (near(middle, past)) {
      past = middle;
    } else {
      before = middle.speed;
    }
  }
  return past;
}

}  // namespace twum::performance
