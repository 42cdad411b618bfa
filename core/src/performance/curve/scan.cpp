// SPDX-License-Identifier: Apache-2.0
#include "performance/curve/scan.hpp"

#include "performance/curve/speed_roots.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace twum::performance {
namespace {

constexpr int kJumpingIntervals = 40;  // in place of kIntervals where torque may jump
constexpr int kMissing = 4;            // points without an answer that may follow one another
constexpr double kFarthest = 1e4;      // times the crest speed
constexpr double kPerRipple = 12;      // nodes
constexpr double kMostRippled = 1500;  // nodes of ripples from rest to the crest speed
constexpr double kRounding = 1e-15;    // of a speed
constexpr double kHighest = 1.3;       // times the crest speed: no wave drives beyond

// True if less than half of the layer's own motion is left after a turn. What is left longer can upset the
// plateau at single speeds, where a turn is a multiple of the layer's own period.
bool forgets_a_turn(const DrivenMotor<double>& m) {
  const contact::ContactNumbers<double> n = contact_numbers(m, 0.0);
  const contact::LayerMotion<double> layer(n.inertia, n.damping);
  return layer.slowest_decay() * 2 * std::numbers::pi > std::numbers::ln2;
}

// Nodes between rest and the crest speed that tell ripples of the torque: it follows the phase in which the layer's
// own oscillation leaves the contact, which speed moves by no more than it turns through before it is over, in the
// contact and in what speed takes from the wave's turn.
double nodes_of_ripples(const DrivenMotor<double>& m) {
  const contact::ContactNumbers<double> n = contact_numbers(m, 0.0);
  const contact::LayerMotion<double> layer(n.inertia, n.damping);
  if (layer.kind() != contact::LayerKind::oscillating) return 0;
  const double over = std::log(100.0) / layer.slowest_decay();
  const double shift = 2 * std::numbers::pi * m.kappa * m.crest_velocity / m.omega;
  const double ringing = std::min(2 * n.half_angle, over) + std::min(shift, over);
  const double ripples = layer.natural_frequency() * ringing / (2 * std::numbers::pi);
  return std::min(kPerRipple * ripples, kMostRippled);
}

}  // namespace

const CurvePoint& CurveScan::first() {
  if (!nodes_.empty()) return nodes_.front();
  const CurvePoint begin = points_.answered(points_.curve().begin());
  const bool holds_back = begin.speed > 0 && !(begin.torque > 0);
  nodes_.push_back(holds_back ? first_that_drives(begin) : begin);
  return nodes_.front();
}

CurvePoint CurveScan::first_that_drives(const CurvePoint& begin) {
  const double crest = points_.curve().crest();
  CurvePoint low = begin;
  for (int i = 1; low.speed < kHighest * crest; ++i) {
    const CurvePoint high = points_.at(begin.speed + i * crest / kIntervals);
    if (!high.ok()) break;
    if (high.torque > 0) {
      const auto torque = [&](double speed) { return points_.answered(speed).torque; };
      return just_beyond(close_in(torque, {low.speed, high.speed, low.torque, high.torque}).high);
    }
    low = high;
  }
  return begin;
}

// The torque may be exactly zero where it rises through zero.
CurvePoint CurveScan::just_beyond(double zero) {
  CurvePoint p = points_.answered(zero);
  for (double step = kRounding * zero; !(p.torque > 0) && step < kAccuracy * zero; step *= 2)
    p = points_.answered(zero + step);
  return p;
}

void CurveScan::require_drive() {
  if (!drives()) throw SearchFailure{MetricStatus::undefined};
}

const std::vector<CurvePoint>& CurveScan::nodes() {
  if (failure_) throw SearchFailure{*failure_};
  if (done_) return nodes_;
  require_drive();
  try {
    run();
    done_ = true;
  } catch (const SearchFailure& failure) {
    failure_ = failure.status;
    throw;
  }
  return nodes_;
}

CurvePoint CurveScan::node(double speed, Walk& walk) {
  return checked(walk.at(speed, kAccuracy), walk);
}

// Exact again where the sign is in doubt. On the plateau all torques are one, but for rounding.
CurvePoint CurveScan::checked(CurvePoint n, Walk& walk) {
  if (n.plateau && starts_on_plateau()) n.torque = first().torque;
  const bool in_doubt = std::fabs(n.torque) < 1e3 * kAccuracy * points_.curve().holding();
  return n.ok() && in_doubt ? walk.at(n.speed) : n;
}

bool CurveScan::ripples() const { return nodes_of_ripples(points_.curve().motor()) > kIntervals; }

const std::vector<CurvePoint>& CurveScan::rippled(const CurvePoint& low, const CurvePoint& high) {
  const auto [place, fresh] = rippled_.try_emplace(low.speed);
  if (!fresh) return place->second;
  const Curve& curve = points_.curve();
  const double spacing = curve.crest() / nodes_of_ripples(curve.motor());
  const int parts = static_cast<int>(std::ceil((high.speed - low.speed) / spacing));
  Walk walk(points_);
  walk.pass(low);
  for (int i = 1; i < parts; ++i) {
    const CurvePoint next = node(low.speed + (high.speed - low.speed) * i / parts, walk);
    if (next.ok()) place->second.push_back(next);
  }
  return place->second;
}

// A layer that slips all through at one speed does so at every lower one: halving finds the last node on
// the plateau, and of those before only the first one is kept. Returns the nodes met beyond, the
// slowest last.
std::vector<CurvePoint> CurveScan::skip_plateau(double step, Walk& walk) {
  int low = 0, high = kIntervals;
  std::vector<CurvePoint> on_plateau, beyond;
  while (high - low > 1) {
    const int middle = (low + high + 1) / 2;
    const CurvePoint next = node(first().speed + middle * step, walk);
    if (!next.ok()) throw SearchFailure{next.status};
    (next.plateau ? low : high) = middle;
    next.plateau ? on_plateau.assign(1, next) : beyond.push_back(next);
  }
  nodes_.insert(nodes_.end(), on_plateau.begin(), on_plateau.end());
  return beyond;
}

void CurveScan::run() {
  const Curve& curve = points_.curve();
  double step = curve.crest() / (curve.may_jump() ? kJumpingIntervals : kIntervals);
  int missing = 0;
  Walk walk(points_);
  const std::vector<CurvePoint> followed = curve.followed();
  for (const CurvePoint& p : followed)
    if (p.speed > nodes_.back().speed && nodes_.back().torque > 0)
      if (const CurvePoint next = checked(p, walk); next.ok()) nodes_.push_back(next);
  std::vector<CurvePoint> known;
  if (followed.empty() && !curve.may_jump() && forgets_a_turn(curve.motor()) && starts_on_plateau())
    known = skip_plateau(step, walk);
  for (double speed = nodes_.back().speed + step; nodes_.back().torque > 0; speed += step) {
    if (speed > kFarthest * curve.crest()) throw SearchFailure{MetricStatus::unresolved};
    if (speed > 2 * curve.crest()) step *= 1.5;
    CurvePoint next;
    if (!known.empty() && known.back().speed < speed + 0.5 * step) {
      next = known.back();
      known.pop_back();
    } else {
      next = node(speed, walk);
    }
    missing = next.ok() ? 0 : missing + 1;
    if (missing > kMissing) throw SearchFailure{next.status};
    if (next.ok()) nodes_.push_back(next);
  }
}

}  // namespace twum::performance
