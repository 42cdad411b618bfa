// SPDX-License-Identifier: Apache-2.0
#include "performance/curve_search.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace twum::performance {
namespace {

constexpr double kNearly = 0.97;   // share of the best node above which another hump may be higher
constexpr double kRippled = 0.95;  // the same, of intervals that ripples may hide a hump in
constexpr double kPerRipple = 12;  // nodes
constexpr double kMostNodes = 1500;  // of ripples from rest to the crest speed
constexpr double kLastTurn = 0.01;   // share of an interval

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
  return std::min(kPerRipple * ripples, kMostNodes);
}

}  // namespace

double CurveSearch::value(Goal goal, const Node& n) const {
  switch (goal) {
    case Goal::torque: return n.torque;
    case Goal::power: return n.torque * n.speed;
    case Goal::efficiency: break;
  }
  return n.torque * n.speed / (n.stator_power + stator_loss(m_));
}

const TorqueSlope& CurveSearch::torque_slope_at(double speed, Trail* trail) {
  for (const auto& [at, kept] : slopes_) {
    if (at == speed) return kept;
  }
  const TorqueSlope t = torque_slope(m_, speed, trail ? trail->at(speed) : nullptr);
  if (t.status != PointStatus::ok) throw SearchFailure{metric_status(t.status)};
  if (trail) trail->add(speed, t.start);
  return slopes_.emplace_back(speed, t).second;
}

CurveSearch::Sloped CurveSearch::sloped(Goal goal, double speed, Trail* trail) {
  const TorqueSlope& t = torque_slope_at(speed, trail);
  const double power = t.torque * speed, power_slope = t.torque + speed * t.slope;
  switch (goal) {
    case Goal::torque: return {t.torque, t.slope};
    case Goal::power: return {power, power_slope};
    case Goal::efficiency: break;
  }
  const double input = t.stator_power + stator_loss(m_);
  return {power / input, (power_slope * input - power * t.power_slope) / (input * input)};
}

// A maximum in an interval where the slope goes from + to -; nothing if it does not.
std::optional<Peak> CurveSearch::peak_between(Goal goal, double low, double high) {
  const auto slope = [&](double speed) { return sloped(goal, speed).slope; };
  if (!(low < high)) return {};
  double at_low = slope(low), at_high = slope(high);
  if (!(at_low > 0)) return {};
  // A zone about to vanish may turn the slope up at the very end.
  if (!(at_high < 0) && !(sloped(goal, high).value < sloped(goal, low).value)) {
    high -= kLastTurn * (high - low);
    at_high = slope(high);
    if (!(at_high < 0)) return {};
  }
  // A dip behind the maximum can hide it: halve towards the higher side.
  for (int i = 0; i < 50 && !(at_high < 0); ++i) {
    const double middle = 0.5 * (low + high);
    const Sloped s = sloped(goal, middle);
    const bool beyond = s.slope < 0 || s.value < sloped(goal, low).value;
    (beyond ? high : low) = middle;
    (beyond ? at_high : at_low) = s.slope;
  }
  if (!(at_high < 0)) return {};
  const Bracket b = close_in(slope, low, high, at_low, at_high);
  const Sloped left = sloped(goal, b.low), right = sloped(goal, b.high);
  const double scale = std::fabs(left.value) / crest_;
  const bool kink = left.slope - right.slope > 1e-4 * scale;
  return left.value >= right.value
             ? Peak{b.low, left.value, kink ? PeakKind::kink : PeakKind::smooth}
             : Peak{b.high, right.value, kink ? PeakKind::kink : PeakKind::smooth};
}

// Where the polynomial through the nodes about `top`, those of the plateau left out, has its maximum; its
// curvature there goes to `curvature`.
double CurveSearch::likely_peak(Goal goal, const std::vector<Node>& nodes, std::size_t top,
                                double& curvature) const {
  Interpolant line;
  for (std::size_t k = top < 2 ? 0 : top - 2; k < std::min(top + 3, nodes.size()); ++k) {
    if (!nodes[k].plateau) line.add(nodes[k].speed, value(goal, nodes[k]));
  }
  double speed = nodes[top].speed;
  for (int i = 0; i < 4; ++i) {
    const Interpolant::Value p = line.at(speed);
    curvature = p.curvature;
    speed -= p.slope / p.curvature;
  }
  return speed;
}

// The zero of the slope by inverse interpolation, from where the nodes about `top` have their maximum;
// nothing if that does not settle at once between its neighbours, as at a kink.
std::optional<Peak> CurveSearch::peak_near(Goal goal, const std::vector<Node>& nodes,
                                           std::size_t top) {
  const Node &a = nodes[top - 1], &b = nodes[top], &c = nodes[top + 1];
  double curvature = 0, speed = likely_peak(goal, nodes, top, curvature);
  Trail trail;
  trail.add(b.speed < speed ? c.speed : a.speed, b.speed < speed ? c.start : a.start);
  trail.add(b.speed, b.start);
  InverseInterpolation line(crest_, 1e-13);
  for (int i = 0; i < 8; ++i) {
    if (!(speed > a.speed && speed < c.speed)) return {};
    const Sloped s = sloped(goal, speed, &trail);
    if (s.slope == 0) return Peak{speed, s.value, PeakKind::smooth};
    line.add(speed, s.slope);
    const double step = i == 0 ? -s.slope / curvature : line.zero() - speed;
    if (!(step * s.slope > 0)) return {};  // not a maximum
    speed += step;
    if (line.settled()) return Peak{speed, s.value + 0.5 * s.slope * step, PeakKind::smooth};
  }
  return {};
}

// With mu_0 > mu the torque may jump there, so the speed stays on its side of the jump.
Peak CurveSearch::named(Peak peak) {
  const bool at_plateau_end = peak.kind == PeakKind::kink && starts_on_plateau() &&
                              std::fabs(peak.speed - plateau_end()) <= 1e-8 * crest_;
  if (!at_plateau_end) return peak;
  if (!rough_) return {plateau_end(), peak.value, PeakKind::plateau_end};
  peak.kind = answered(peak.speed).plateau ? PeakKind::plateau_end : PeakKind::beyond_plateau;
  return peak;
}

std::size_t CurveSearch::highest(Goal goal, const std::vector<Node>& nodes) const {
  std::size_t top = 0;
  for (std::size_t k = 1; k < nodes.size(); ++k) {
    if (value(goal, nodes[k]) > value(goal, nodes[top])) top = k;
  }
  return top;
}

// More nodes where a ripple between two of them may be the highest. Those without an answer are left out.
void CurveSearch::add_ripples(Goal goal, std::vector<Node>& nodes) const {
  const double wanted = nodes_of_ripples(m_), spacing = crest_ / wanted;
  if (!(wanted > kIntervals)) return;
  const double worth = kRippled * value(goal, nodes[highest(goal, nodes)]);
  std::vector<Node> all(nodes.begin(), nodes.begin() + 1);
  for (std::size_t k = 1; k < nodes.size(); ++k) {
    const Node &low = nodes[k - 1], &high = nodes[k];
    const bool worthy = !high.plateau && std::max(value(goal, low), value(goal, high)) >= worth;
    const int parts = worthy ? static_cast<int>(std::ceil((high.speed - low.speed) / spacing)) : 1;
    Trail trail;
    trail.add(low.speed, low.start);
    for (int i = 1; i < parts; ++i) {
      const Node between = scanned(low.speed + (high.speed - low.speed) * i / parts, trail);
      if (between.ok()) all.push_back(between);
    }
    all.push_back(high);
  }
  nodes = std::move(all);
}

Peak CurveSearch::smooth_peak(Goal goal, const std::vector<Node>& nodes, std::size_t top) {
  Peak best = peak_beside(goal, nodes, top);
  const auto consider = [&](const Peak& peak) {
    if (peak.value > best.value) best = peak;
  };
  const auto at = [&](std::size_t k) { return value(goal, nodes[k]); };
  for (std::size_t k = 0; k + 1 < nodes.size(); ++k) {
    const bool hump = (k == 0 || at(k) >= at(k - 1)) && at(k) >= at(k + 1);
    if (hump && k != top && at(k) >= kNearly * at(top)) consider(peak_beside(goal, nodes, k));
  }
  if (goal != Goal::torque && plateau_may_top(goal, nodes, best.value)) {
    const Node end = answered(plateau_end());
    consider({end.speed, value(goal, end), PeakKind::plateau_end});
  }
  return best;
}

// Power and efficiency may have their maximum at the plateau's end, a kink, wherever the best node is.
bool CurveSearch::plateau_may_top(Goal goal, const std::vector<Node>& nodes, double best) {
  if (!starts_on_plateau()) return false;
  std::size_t k = 1;
  while (k < nodes.size() && nodes[k].plateau) ++k;
  if (k == nodes.size()) return false;
  Node most = nodes[k];
  most.torque = nodes[0].torque;
  most.stator_power = std::min(nodes[k - 1].stator_power, nodes[k].stator_power);
  return value(goal, most) > best;
}

// Where a speed beside it has no answer, as without damping, the node stands for the maximum.
Peak CurveSearch::peak_beside(Goal goal, const std::vector<Node>& nodes, std::size_t top) {
  try {
    return sharp_peak(goal, nodes, top);
  } catch (const SearchFailure&) {
    const Node n = answered(nodes[top].speed);
    return {n.speed, value(goal, n), top == 0 ? PeakKind::rest : PeakKind::kink};
  }
}

Peak CurveSearch::sharp_peak(Goal goal, const std::vector<Node>& nodes, std::size_t top) {
  if (top > 0 && top + 1 < nodes.size()) {
    const std::optional<Peak> near = peak_near(goal, nodes, top);
    if (near && near->value >= value(goal, nodes[top]) * (1 - 1e3 * kScanAccuracy)) return *near;
  }
  const Peak at_node{nodes[top].speed, value(goal, answered(nodes[top].speed)),
                     top == 0 ? PeakKind::rest : PeakKind::smooth};
  if (nodes.size() == 1) return at_node;
  const bool rises = sloped(goal, nodes[top].speed).slope > 0;
  if (!rises && top == 0) return at_node;
  if (rises && top + 1 == nodes.size()) return at_node;
  const std::size_t from = rises ? top : top - 1;
  const std::optional<Peak> inside = peak_between(goal, nodes[from].speed, nodes[from + 1].speed);
  return inside && inside->value >= at_node.value ? named(*inside) : at_node;
}

// Torque that may jump: every stretch with the same sequence of zones, or without a periodic state, is
// taken by itself, its ends located by halving.
Peak CurveSearch::rough_peak(Goal goal, const std::vector<Node>& nodes, std::size_t top) {
  Peak best{nodes[top].speed, value(goal, nodes[top]), top == 0 ? PeakKind::rest : PeakKind::kink};
  const auto consider = [&](const Node& n) {
    if (n.ok() && value(goal, n) > best.value) best = {n.speed, value(goal, n), PeakKind::kink};
  };
  const double worth = kWorth * best.value;
  lost_ = 0;
  for (std::size_t k = 0; k + 1 < nodes.size(); ++k) {
    if (std::max(value(goal, nodes[k]), value(goal, nodes[k + 1])) < worth) continue;
    for (const Stretch& stretch : stretches(nodes[k], nodes[k + 1])) {
      consider(stretch.first);
      const bool level = goal == Goal::torque && stretch.first.plateau;
      if (stretch.first.ok() && !level && stretch.first.speed < stretch.last.speed) {
        for (const Peak& inside : peaks_inside(goal, stretch, kNearly * best.value))
          if (inside.value > best.value) best = inside;
      }
      consider(stretch.last);
    }
  }
  return named(best);
}

// Maxima between neighbouring places of a stretch of which one has the value `worth`. A zone that is just born has
// an end without slope: the ends are a little inside.
std::vector<Peak> CurveSearch::peaks_inside(Goal goal, const Stretch& stretch, double worth) {
  const double low = stretch.first.speed, high = stretch.last.speed, inset = kInset * (high - low);
  std::vector<double> places{low + inset};
  places.insert(places.end(), stretch.inside.begin(), stretch.inside.end());
  places.push_back(high - inset);
  std::vector<Peak> peaks;
  for (std::size_t k = 1; k < places.size(); ++k) {
    const bool worthy = stretch.inside.empty() || std::max(sloped(goal, places[k - 1]).value,
                                                           sloped(goal, places[k]).value) >= worth;
    if (!worthy) continue;
    if (const std::optional<Peak> peak = peak_between(goal, places[k - 1], places[k]))
      peaks.push_back(*peak);
  }
  return peaks;
}

Peak CurveSearch::peak(Goal goal) {
  std::optional<Peak>& kept = peaks_[static_cast<int>(goal)];
  if (kept) return *kept;
  require_drive();
  // |T| <= mu F_N r: a motor that stalls on its plateau cannot do better.
  if (goal == Goal::torque && !rough_ && starts_on_plateau()) {
    return *(kept = Peak{0, stall_torque(), PeakKind::rest});
  }
  std::vector<Node> nodes = working_nodes();
  if (!rough_) add_ripples(goal, nodes);
  const std::size_t top = highest(goal, nodes);
  kept = rough_ ? rough_peak(goal, nodes, top) : smooth_peak(goal, nodes, top);
  if (goal == Goal::torque && kept->value <= stall_torque() * (1 + 1e-14)) {
    kept = Peak{0, stall_torque(), PeakKind::rest};
  }
  return *kept;
}

Peak CurveSearch::max_torque() { return peak(Goal::torque); }

Peak CurveSearch::peak_power() {
  if (!(stall_torque() > 0)) return {0, 0, PeakKind::rest};
  return peak(Goal::power);
}

Peak CurveSearch::working_peak() {
  require_drive();
  return peak_power();
}

Peak CurveSearch::max_efficiency() {
  if (!(m_.stator_damping > 0)) throw SearchFailure{MetricStatus::undefined};
  return peak(Goal::efficiency);
}

}  // namespace twum::performance
