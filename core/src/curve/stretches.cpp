// SPDX-License-Identifier: Apache-2.0
#include "curve/stretches.hpp"

#include <cmath>

namespace twum::inline v0_1::core {
namespace {

constexpr std::size_t kStretches = 8;  // sequences of zones between two points
constexpr double kSteady = 1e-4;       // of the holding torque: what a mean slope may leave
constexpr double kGlimpse = 1e-3;      // of what lies between two points
constexpr double kGapEnd = 1e-13;      // of the crest speed
constexpr double kJump = 1e-6;  // of the holding torque: more than torque moves in so short a share

}  // namespace

const Vector<Stretch>& CurveStretches::between(const CurvePoint& low, const CurvePoint& end) {
  const std::pair<double, double> speeds{low.speed, end.speed};
  const auto place = known_.find(speeds);
  return place != known_.end() ? place->second
                               : known_.emplace(speeds, found_between(low, end)).first->second;
}

Vector<Stretch> CurveStretches::found_between(const CurvePoint& low, const CurvePoint& end) {
  Vector<Stretch> all;
  CurvePoint before = low;
  Stretch stretch{low, low, {}};
  const auto cut = [&](const CurvePoint& left, const CurvePoint& right) {
    stretch.last = left;
    all.push_back(stretch);
    stretch = {right, right, {}};
  };
  for (const CurvePoint& next : steady_between(low, end)) {
    const bool jump = before.signature == next.signature && !is_steady(before, next);
    if (jump && all.size() + 1 < kStretches) cut(before, next);
    // Where zones are born, rounding can tell many sequences apart: the rest counts as one stretch.
    while (before.signature != next.signature && all.size() + 1 < kStretches) {
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

// The sequence of zones at the middle tells of a stretch what it is: beside its ends it may be another by rounding.
bool CurveStretches::is_gap(double low, double high) const {
  return high - low > kGap * points_.curve().crest() &&
         points_.at(0.5 * (low + high)).status == MetricStatus::no_periodic_state;
}

Glimpse CurveStretches::glimpse(const CurvePoint& low, const CurvePoint& end,
                                FunctionRef<bool(const CurvePoint&)> worth) {
  constexpr Glimpse kTooMuch{.worthy = true};
  const double close = kGlimpse * (end.speed - low.speed);
  Glimpse seen;
  CurvePoint before = low;
  double last_with_state = low.speed, first_without = low.speed;
  std::size_t ends = 0;
  for (const CurvePoint& next : steady_between(low, end)) {
    if (before.signature == next.signature && !is_steady(before, next)) return kTooMuch;
    while (before.signature != next.signature) {
      if (++ends == kStretches) return kTooMuch;
      CurvePoint left = before, right = next;
      while (right.speed - left.speed > close) {
        const CurvePoint& middle = halving_.at(0.5 * (left.speed + right.speed));
        (middle.signature == before.signature ? left : right) = middle;
      }
      seen.worthy = seen.worthy || worth(left) || worth(right);
      if (left.ok()) {
        last_with_state = left.speed, first_without = right.speed;
      } else {
        seen.gap = seen.gap || is_gap(first_without, left.speed);
        seen.worthy = seen.worthy || (!seen.gap && is_gap(last_with_state, right.speed));
      }
      before = right;
    }
    seen.worthy = seen.worthy || worth(next);
    before = next;
  }
  return seen;
}

// Points from beyond `low` to `high` such that between neighbours with the same zones the torque goes as its slopes say.
Vector<CurvePoint> CurveStretches::steady_between(const CurvePoint& low, const CurvePoint& high) {
  if (low.signature != high.signature || is_steady(low, high)) return {high};
  const CurvePoint& middle = halving_.at(0.5 * (low.speed + high.speed));
  if (!(low.speed < middle.speed && middle.speed < high.speed)) return {high};
  Vector<CurvePoint> points = steady_between(low, middle);
  const Vector<CurvePoint> beyond = steady_between(middle, high);
  points.insert(points.end(), beyond.begin(), beyond.end());
  return points;
}

// True if the torque's change is that of its mean slope.
bool CurveStretches::is_steady(const CurvePoint& low, const CurvePoint& high) {
  if (!low.ok() || (low.plateau && high.plateau)) return true;
  const double slope =
      0.5 * (points_.slope(low.speed).torque.slope + points_.slope(high.speed).torque.slope);
  const double rest = high.torque - low.torque - slope * (high.speed - low.speed);
  return std::fabs(rest) <= kSteady * points_.curve().holding();
}

bool CurveStretches::are_neighbours(double low, double high) const {
  return std::fabs(high - low) <= 4e-16 * (points_.curve().crest() + high);
}

// Beside the end of speeds with a periodic state it takes laps by the hundred to tell whether there is one: a few roundings are left.
bool CurveStretches::meet_at_gap(const CurvePoint& left, const CurvePoint& right) const {
  return left.ok() != right.ok() &&
         std::fabs(right.speed - left.speed) <= kGapEnd * points_.curve().crest();
}

// Neighbouring speeds between which one slice changes its zones. Only slices are solved that have other zones at `end` than at
// `low`, since a jump is that of one slice. If slices cannot be solved by themselves: the two speeds.
std::pair<double, double> CurveStretches::change_of_slices(const CurvePoint& low,
                                                           const CurvePoint& end) {
  struct Slice {
    std::size_t index;
    std::optional<std::uint64_t> signature;  // at the low end
  };
  const auto changed_at = [this](double speed, const Vector<Slice>& slices) {
    Vector<Slice> changed;
    for (const Slice& s : slices)
      if (halving_.slice_at(speed, s.index) != s.signature) changed.push_back(s);
    return changed;
  };
  double left = low.speed, right = end.speed;
  Vector<Slice> slices;
  if (low.ok() && !low.special && !end.special)
    for (std::size_t k = 0; k < points_.curve().own_slices(); ++k)
      slices.push_back({k, halving_.slice_at(left, k)});
  slices = changed_at(right, slices);
  while (!slices.empty() && !are_neighbours(left, right)) {
    const double middle = 0.5 * (left + right);
    if (middle <= left || middle >= right) break;
    Vector<Slice> changed = changed_at(middle, slices);
    if (changed.empty()) {
      left = middle;
    } else {
      right = middle, slices = std::move(changed);
    }
  }
  return {left, right};
}

// Neighbouring speeds between which the sequence of zones that holds at `low` ends.
std::pair<CurvePoint, CurvePoint> CurveStretches::stretch_end(const CurvePoint& low,
                                                              const CurvePoint& end) {
  const auto [last, next] = change_of_slices(low, end);
  CurvePoint left = halving_.at(last), right = halving_.at(next);
  if (left.signature != low.signature) right = left, left = low;  // another slice changes before
  while (!are_neighbours(left.speed, right.speed) && !meet_at_gap(left, right)) {
    const CurvePoint& middle = halving_.at(0.5 * (left.speed + right.speed));
    if (middle.speed <= left.speed || middle.speed >= right.speed) break;
    (middle.signature == low.signature ? left : right) = middle;
  }
  return {past_jump(left, left.speed - kInset * (left.speed - low.speed)),
          past_jump(right, right.speed + kInset * (end.speed - right.speed))};
}

// The end of a stretch, or a place just inside of it where the torque jumps: a zone that has just begun may grow at once.
CurvePoint CurveStretches::past_jump(const CurvePoint& end, double inside) {
  CurvePoint past = halving_.at(inside);
  const auto near = [this](const CurvePoint& a, const CurvePoint& b) {
    return a.signature == b.signature &&
           std::fabs(a.torque - b.torque) <= kJump * points_.curve().holding();
  };
  if (past.signature != end.signature || near(past, end)) return end;
  double before = end.speed;
  while (!are_neighbours(before, past.speed)) {
    const CurvePoint& middle = halving_.at(0.5 * (before + past.speed));
    if (middle.speed == before || middle.speed == past.speed) break;
    if (near(middle, past)) {
      past = middle;
    } else {
      before = middle.speed;
    }
  }
  return past;
}

}  // namespace twum::inline v0_1::core
