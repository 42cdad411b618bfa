// SPDX-License-Identifier: Apache-2.0
#include "curve/points.hpp"

#include <cmath>
#include <cstddef>

namespace twum::inline v0_1::core {
namespace {

constexpr double kFarBeyond = 3;           // distances of the last two points
constexpr std::size_t kMostKept = 20'000;  // points of a motor; usual ones need some hundred
constexpr long kMostLost = 1'000'000;  // zones that one search may follow in vain: about a second

}  // namespace

CurvePoint CurvePoints::answered(double speed) const {
  const CurvePoint p = at(speed);
  if (!p.ok()) throw SearchFailure{p.status};
  return p;
}

const CurvePoint& CurvePoints::stored_point(double speed) {
  if (kept_.size() >= kMostKept) throw SearchFailure{MetricStatus::unresolved};
  const auto [place, fresh] = kept_.try_emplace(speed);
  if (fresh) place->second = at(speed);
  return place->second;
}

CurveSlope CurvePoints::slope(double speed, const WarmStart* guess) {
  for (const CurveSlope& kept : slopes_) {
    if (kept.speed == speed) return kept;
  }
  return slopes_.emplace_back(curve_.slope(speed, guess));
}

void Walk::pass(double speed, const WarmStart& start) {
  before_ = last_;
  last_ = Known{speed, start};
}

// Along the line through the two states, unless that leads far away. Null at first.
const WarmStart* Walk::extrapolated_start(double speed) {
  if (!last_) return nullptr;
  guess_ = last_->start;
  if (before_ && before_->speed != last_->speed) {
    const double t = (speed - last_->speed) / (last_->speed - before_->speed);
    if (std::fabs(t) <= kFarBeyond)
      guess_ = WarmStart::extrapolated(before_->start, last_->start, t);
  }
  return &guess_;
}

CurvePoint Walk::at(double speed, double accuracy) {
  const CurvePoint p = points_.curve().point(speed, extrapolated_start(speed), accuracy);
  if (p.ok() && !p.special) pass(p);
  return p;
}

CurvePoint Walk::answered(double speed) {
  const CurvePoint p = at(speed);
  if (!p.ok()) throw SearchFailure{p.status};
  return p;
}

CurveSlope Walk::slope(double speed) {
  const CurveSlope slope = points_.slope(speed, extrapolated_start(speed));
  pass(speed, slope.start);
  return slope;
}

const CurvePoint& Halving::at(double speed) {
  const CurvePoint& p = points_.stored_point(speed);
  lose(p.lost, p.status);
  return p;
}

std::optional<std::uint64_t> Halving::slice_at(double speed, std::size_t slice) {
  const SliceAnswer answer = points_.curve().slice(speed, slice);
  lose(answer.lost, MetricStatus::no_periodic_state);
  return answer.signature;
}

void Halving::lose(long zones, MetricStatus status) {
  lost_ += zones;
  if (lost_ > kMostLost) throw SearchFailure{status};
}

}  // namespace twum::inline v0_1::core
