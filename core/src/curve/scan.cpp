// SPDX-License-Identifier: Apache-2.0
#include "curve/scan.hpp"

#include "curve/speed_roots.hpp"

#include <twum/base/scalar_search.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace twum::inline v0_1::core {
namespace {

constexpr int kJumpingIntervals = 40;  // in place of kIntervals where torque may jump
constexpr int kMissing = 4;            // points without an answer that may follow one another
constexpr double kFarthest = 1e4;      // times the crest speed
constexpr double kPerRipple = 12;      // nodes
constexpr double kMostRippled = 1500;  // nodes of ripples from rest to the crest speed
constexpr double kFewRipples = 60;     // nodes: a radian of a ripple is V0 / (30 r)
constexpr double kRounding = 1e-15;    // of a speed
constexpr double kHighest = 1.3;       // times the crest speed: no wave drives beyond

// True if less than half of the layer's own motion is left after a turn. What is left longer can upset the
// plateau at single speeds, where a turn is a multiple of the layer's own period.
bool forgets_a_turn(const DrivenMotor<double>& m) {
  const contact::ContactNumbers<double> n = contact_numbers(m, 0.0);
  const contact::LayerMotion<double> layer(n.inertia, n.damping);
  return layer.slowest_decay() * 2 * std::numbers::pi > std::numbers::ln2;
}

// How many samples between rest and the crest speed resolve the ripples of the torque. Each ripple is one turn of the layer's own
// oscillation at the exit of the contact; the count is the number of such turns that fit into the contact, and into what the
// speed takes from the wave's turn, before the oscillation has decayed to 1 %.
double nodes_of_ripples(const DrivenMotor<double>& m) {
  const contact::ContactNumbers<double> n = contact_numbers(m, 0.0);
  const contact::LayerMotion<double> layer(n.inertia, n.damping);
  if (layer.kind() != contact::LayerKind::oscillating) return 0;
  const double over = std::log(100.0) / layer.slowest_decay();
  const double shift = 2 * std::numbers::pi * m.kappa * m.mean.crest_velocity / m.omega;
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

// Among the points of a curve that was followed, which are as close as it bends, and between the two beside the one of most
// torque.
CurvePoint CurveScan::first_that_drives(const CurvePoint& begin) {
  Vector<CurvePoint> known{begin};
  for (const CurvePoint& p : points_.curve().known_points())
    if (p.speed > begin.speed) known.push_back(p);
  const double crest = points_.curve().crest();
  for (int i = 1; known.size() < 3 && i < kHighest * kIntervals; ++i)
    known.push_back(points_.at(begin.speed + i * crest / kIntervals));
  const auto torque = [&](double speed) { return points_.answered(speed).torque; };
  std::size_t most = 0;
  for (std::size_t i = 1; i < known.size() && known[i].ok(); ++i) {
    if (known[i].torque > 0)
      return just_beyond(close_in(torque, {known[i - 1].speed, known[i].speed, known[i - 1].torque,
                                           known[i].torque})
                             .high);
    if (known[i].torque > known[most].torque) most = i;
  }
  if (most == 0 || most + 1 >= known.size()) return begin;
  const double low = known[most - 1].speed, high = known[most + 1].speed;
  const LeastValue top = least_between(
      "the most torque near the beginning", [&](double s) { return -torque(s); }, low, high);
  if (!(top.value < 0)) return begin;
  return just_beyond(close_in(torque, {low, top.place, known[most - 1].torque, -top.value}).high);
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

const Vector<CurvePoint>& CurveScan::nodes() {
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

bool CurveScan::in_doubt(double excess) const {
  return std::fabs(excess) < 1e3 * kAccuracy * points_.curve().holding();
}

// Exact again where the sign is in doubt. On the plateau all torques are one, but for rounding.
CurvePoint CurveScan::checked(CurvePoint n, Walk& walk) {
  if (n.plateau && starts_on_plateau()) n.torque = first().torque;
  return n.ok() && in_doubt(n.torque) ? walk.at(n.speed) : n;
}

bool CurveScan::falls_smoothly() const {
  const Curve& curve = points_.curve();
  const DrivenMotor<double>& m = curve.motor();
  return curve.falls() && forgets_a_turn(m) && nodes_of_ripples(m) <= kFewRipples;
}

bool CurveScan::ripples() const { return nodes_of_ripples(points_.curve().motor()) > kIntervals; }

const Vector<CurvePoint>& CurveScan::rippled(const CurvePoint& low, const CurvePoint& high) {
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

double CurveScan::step() const {
  const Curve& curve = points_.curve();
  return curve.crest() / (curve.has_static_excess() ? kJumpingIntervals : kIntervals);
}

const CurvePoint& CurveScan::on_grid(int k) {
  const auto [place, fresh] = grid_.try_emplace(k);
  if (fresh) place->second = node(first().speed + k * step(), walk_);
  return place->second;
}

int CurveScan::below(double speed) {
  return static_cast<int>(std::ceil((speed - first().speed) / step())) - 1;
}

// A layer that slips all through at one speed does so at every lower one: halving finds the last node on
// the plateau, and of those before only the first one is kept.
void CurveScan::skip_plateau() {
  int low = 0, high = kIntervals;
  for (const auto& [k, p] : grid_) {
    if (p.ok() && p.plateau) low = std::max(low, k);
    if (p.ok() && !p.plateau) high = std::min(high, k);
  }
  while (high - low > 1) {
    const int middle = (low + high + 1) / 2;
    const CurvePoint& next = on_grid(middle);
    if (!next.ok()) throw SearchFailure{next.status};
    (next.plateau ? low : high) = middle;
  }
  if (low > 0) nodes_.push_back(on_grid(low));
}

void CurveScan::run() {
  const Curve& curve = points_.curve();
  int missing = 0;
  const Vector<CurvePoint> followed = curve.known_points();
  for (const CurvePoint& p : followed)
    if (p.speed > nodes_.back().speed && nodes_.back().torque > 0)
      if (const CurvePoint next = checked(p, walk_); next.ok()) nodes_.push_back(next);
  if (followed.empty() && !curve.has_static_excess() && forgets_a_turn(curve.motor()) &&
      starts_on_plateau())
    skip_plateau();
  double stride = step();
  for (double speed = nodes_.back().speed + stride; nodes_.back().torque > 0; speed += stride) {
    if (speed > kFarthest * curve.crest()) throw SearchFailure{MetricStatus::unresolved};
    if (speed > 2 * curve.crest()) stride *= 1.5;
    const bool by_steps = followed.empty() && speed <= 2 * curve.crest();
    const CurvePoint next =
        by_steps ? on_grid(static_cast<int>(std::lround((speed - first().speed) / step())))
                 : node(speed, walk_);
    if (next.status == MetricStatus::no_periodic_state) gaps_.push_back(speed);
    missing = next.ok() ? 0 : missing + 1;
    if (missing > kMissing) throw SearchFailure{next.status};
    if (next.ok()) nodes_.push_back(next);
  }
}

}  // namespace twum::inline v0_1::core
