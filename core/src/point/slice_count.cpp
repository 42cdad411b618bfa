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
#include <optional>

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

// Compares points of a motor under numbers of nodes that follow one another. Each is computed when it is needed: most numbers are
// refuted by a single speed, and by the one that refuted the number before.
class NodeSearch {
 public:
  NodeSearch(const ModelArray<double>& values, const TrackRule& rule)
      : values_(values), rule_(rule) {}

  bool is_trivial() { return core::is_trivial(with_count(0).motor); }

  /// The next number changes no point: the difference is the error of this one.
  bool suffices(std::size_t count) {
    for (std::size_t i = 0; i < kSpeeds.size(); ++i) {
      const std::size_t speed = (refuting_ + i) % kSpeeds.size();
      const SolvedPoint& next = point(count + 1, speed);
      if (difference(with_count(count).motor, point(count, speed), next) > kWanted) {
        refuting_ = speed;
        return false;
      }
    }
    return true;
  }

 private:
  struct OfCount {
    DrivenMotor<double> motor;
    std::array<std::optional<SolvedPoint>, kSpeeds.size()> points{};
  };

  OfCount& with_count(std::size_t count) {
    if (const auto known = known_.find(count); known != known_.end()) return known->second;
    TrackRule rule = rule_;
    rule.nodes = kCounts[count];
    return known_.emplace(count, OfCount{driven(motor_model(values_, rule), design_wave(values_))})
        .first->second;
  }

  // Jumps lie where fewer nodes have found them.
  const SolvedPoint& point(std::size_t count, std::size_t at) {
    OfCount& of = with_count(count);
    std::optional<SolvedPoint>& known = of.points[at];
    if (known) return *known;
    const double speed = kSpeeds[at] * of.motor.mean.crest_velocity / of.motor.r;
    if (count > 0 && has_static_excess(of.motor)) {
      const SolvedPoint& fewer = point(count - 1, at);
      return known.emplace(solve_point_near(of.motor, speed, fewer, fewer.start()));
    }
    return known.emplace(solve_point(of.motor, speed, nullptr, kStates));
  }

  const ModelArray<double>& values_;
  const TrackRule& rule_;
  Map<std::size_t, OfCount> known_;
  std::size_t refuting_{0};
};

// The first number of nodes that suffices. If there is none, the largest.
TrackRule with_nodes_needed(const ModelArray<double>& values, TrackRule rule, int most) {
  NodeSearch search(values, rule);
  std::size_t count = 0;
  if (!search.is_trivial())
    while (count + 1 < kCounts.size() && kCounts[count + 1] <= most && !search.suffices(count))
      ++count;
  rule.settled = kCounts[count] < most;
  rule.nodes = kCounts[count];
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
  TrackRule rule{std::abs(stator.radial_slices),
                 table.empty() ? nullptr : std::make_shared<const ShapeSpline>(table),
                 stator.geometry.has_value(), false, stator.radial_motion};
  if (stator.radial_slices > kAutoSlices) return rule;
  const ModelArray<double> values = model_values(design);
  const bool jumps = design.friction.threshold > design.friction.kinetic;
  // The jumps of a surface that moves radially are not followed.
  const bool stays_whole =
      jumps &&
      (stator.radial_motion || remembers_long(driven(motor_model(values), design_wave(values))));
  rule.splits = !stays_whole;
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
