// SPDX-License-Identifier: Apache-2.0
// How many nodes a panel the numbers of a motor take: radial_slices = auto.
#include "point/slice_count.hpp"

#include "design/wear_design.hpp"
#include "point/point.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace twum::inline v0_1::core {
namespace {

constexpr double kStates = 1e-9;  // of the periodic states, far less than what is wanted
constexpr double kWanted = 1e-6;  // of the scales of torque and powers
constexpr std::array kCounts{6, 8, 10, 12, 16, 24, 32, 48, 64, 96, 128};
// Share of the layer's motion that outlives the free flight, above which a track that jumps is not split.
constexpr double kLong = 0.5;
// Where torque may jump. Four times as many leave a third of the error, and metrics take five times as long.
constexpr int kMostWithJumps = 32;
// Zones that the search in the middle of the track may follow at one speed; usual motors need some tens. A stiff layer without
// damping needs thousands and milliseconds, far from any motor: then the track has few slices and no splits.
constexpr long kMostLaborious = 5000;
constexpr int kOfLaborious = 8;
// Speeds in parts of the crest speed: from the end of the plateau to full braking zones come and go along the track.
constexpr std::array kSpeeds{0.2, 0.5, 0.65, 0.75, 0.8, 0.85, 0.9, 0.95, 1.0, 1.05, 1.1, 1.2, 1.4};

using Numbers = std::array<SolvedPoint, kSpeeds.size()>;

DrivenMotor<double> motor_of(const ModelArray<double>& values, const TrackRule& rule, int nodes) {
  TrackRule with_nodes = rule;
  with_nodes.nodes = nodes;
  return driven(motor_model(values, with_nodes), design_wave(values));
}

// Largest difference of two points in units of their scales; points without an answer say nothing.
double difference(const DrivenMotor<double>& m, const SolvedPoint& a, const SolvedPoint& b) {
  if (a.status != PointStatus::ok || b.status != PointStatus::ok) return 0;
  const double torque = holding_torque(m), power = torque * m.mean.crest_velocity / m.r;
  const PointNumbers<double>&p = a.numbers, &q = b.numbers;
  return std::max({std::fabs(p.torque - q.torque) / torque,
                   std::fabs(p.stator_power - q.stator_power) / power,
                   std::fabs(p.friction_power - q.friction_power) / power,
                   std::fabs(p.layer_loss - q.layer_loss) / power});
}

// Jumps lie where fewer nodes have found them.
Numbers points_of(const DrivenMotor<double>& m, const Numbers* fewer) {
  Numbers points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double speed = kSpeeds[i] * m.mean.crest_velocity / m.r;
    points[i] = fewer && has_static_excess(m)
                    ? solve_point_near(m, speed, (*fewer)[i], (*fewer)[i].start())
                    : solve_point(m, speed, nullptr, kStates);
  }
  return points;
}

// Largest difference over the speeds.
double difference(const DrivenMotor<double>& m, const Numbers& a, const Numbers& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, difference(m, a[i], b[i]));
  return most;
}

// The first number of nodes whose points the next number does not change: the difference is the error of the former. If there
// is none, the largest.
TrackRule with_nodes_needed(const ModelArray<double>& values, TrackRule rule, int most) {
  const auto settled = [&rule](int nodes) {
    rule.nodes = nodes;
    return rule;
  };
  Numbers before;
  for (std::size_t i = 0; i < kCounts.size() && kCounts[i] <= most; ++i) {
    const DrivenMotor<double> motor = motor_of(values, rule, kCounts[i]);
    if (is_trivial(motor)) return settled(kCounts[i]);
    const Numbers points = points_of(motor, i > 0 ? &before : nullptr);
    if (i > 0 && difference(motor, before, points) <= kWanted) return settled(kCounts[i - 1]);
    before = points;
  }
  rule.nodes = most, rule.settled = false;
  return rule;
}

// True if much of the layer's own motion is left after a turn. Such slices take many laps to settle, and many of those near a
// jump have no periodic state: a split track would be slow and often without an answer.
bool remembers_long(const DrivenMotor<double>& m) {
  const contact::ContactNumbers<double> n = contact_numbers(m, 0.0);
  const contact::LayerMotion<double> layer(n.inertia, n.damping);
  return n.full || std::exp(-layer.slowest_decay() * 2 * (std::numbers::pi - n.half_angle)) > kLong;
}

bool is_laborious(const ModelArray<double>& values) {
  const DrivenMotor<double> m = driven(motor_model(values), design_wave(values));
  return std::any_of(kSpeeds.begin(), kSpeeds.end(), [&](double share) {
    const double speed = share * m.mean.crest_velocity / m.r;
    return solve_point(m, speed, nullptr, kStates).zones_followed() > kMostLaborious;
  });
}

#ifndef __wasm__
TrackRule worn_track_rule(const MotorDesign& design) {
  const auto& table = design.stator.radial_shape.table;
  const auto worn = std::make_shared<const WornTrack>(
      WornTrack{design.wear->deviations, thickness_share(design)});
  return {.nodes = worn->nodes(),
          .table = table.empty() ? nullptr : std::make_shared<const ShapeSpline>(table),
          .mode = design.stator.geometry.has_value(),
          .radial = design.stator.radial_motion,
          .worn = worn};
}
#endif

}  // namespace

TrackRule track_rule(const MotorDesign& design) {
  const Stator& stator = design.stator;
  const auto& table = stator.radial_shape.table;
#ifndef __wasm__  // see worn_track()
  if (design.wear && !design.wear->deviations.empty()) return worn_track_rule(design);
#endif
  const ModelArray<double> values = model_values(design);
  const bool jumps = design.friction.threshold > design.friction.kinetic;
  // The jumps of a surface that moves radially are not followed.
  const bool stays_whole =
      jumps &&
      (stator.radial_motion || remembers_long(driven(motor_model(values), design_wave(values))));
  TrackRule rule{std::abs(stator.radial_slices),
                 table.empty() ? nullptr : std::make_shared<const ShapeSpline>(table),
                 stator.geometry.has_value(), stator.radial_slices <= kAutoSlices && !stays_whole,
                 stator.radial_motion};
  // A motor under a voltage has no wave here; Drive asks again with one.
  if (rule.splits && !stator.voltage && is_laborious(values)) {
    rule.splits = false;
    if (rule.nodes == kAutoSlices) rule.nodes = kOfLaborious, rule.settled = false;
  }
  if (rule.nodes == kAutoSlices)
    return with_nodes_needed(values, rule, jumps ? kMostWithJumps : kCounts.back());
  return rule;
}

}  // namespace twum::inline v0_1::core
