// SPDX-License-Identifier: Apache-2.0
#include "performance/curve_search.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace twum::performance {
namespace {

constexpr int kRoughIntervals = 40;
constexpr int kMissing = 4;            // points without an answer that may follow one another
constexpr double kFarthest = 1e4;      // times the crest speed
constexpr double kSameTorque = 1e-14;  // what rounding leaves of the plateau's torque
constexpr std::size_t kMostHalved =
    20'000;  // nodes of halvings in one search; usual motors need some hundred
constexpr long kMostLost = 1'000'000;  // zones that one search may follow in vain: about a second

// True if less than half of the layer's own motion is left after a turn. What is left longer can upset the
// plateau at single speeds, where a turn is a multiple of the layer's own period.
bool forgets_a_turn(const DrivenMotor<double>& m) {
  const contact::ContactNumbers<double> n = contact_numbers(m, 0.0);
  const contact::LayerMotion<double> layer(n.inertia, n.damping);
  return layer.slowest_decay() * 2 * std::numbers::pi > std::numbers::ln2;
}

}  // namespace

MetricStatus metric_status(PointStatus status) {
  switch (status) {
    case PointStatus::ok: return MetricStatus::ok;
    case PointStatus::no_periodic_state: return MetricStatus::no_periodic_state;
    case PointStatus::not_converged: return MetricStatus::not_converged;
    case PointStatus::resonance: return MetricStatus::resonance;
    case PointStatus::unresolved: return MetricStatus::unresolved;
    case PointStatus::inaccurate: return MetricStatus::inaccurate;
  }
  return MetricStatus::unresolved;
}

CurveSearch::CurveSearch(const DrivenMotor<double>& model)
    : m_(model),
      holding_(holding_torque(model)),
      crest_(model.crest_velocity / model.r),
      rough_(model.static_ > model.kinetic) {}

CurveSearch::Node CurveSearch::node(double speed, Trail* trail, double accuracy) const {
  const SolvedPoint p = solve_point(m_, speed, trail ? trail->at(speed) : nullptr, accuracy);
  if (p.status != PointStatus::ok)
    return {speed, 0, 0, false, kNoState, metric_status(p.status), {}, p.zones_followed()};
  if (trail && !p.special) trail->add(speed, p.start());
  return {speed,      p.numbers.torque, p.numbers.stator_power,
          p.drives(), p.signature(),    MetricStatus::ok,
          p.start()};
}

// Nodes only say between which speeds to look, so they need not be exact, unless their sign is in doubt. On
// the plateau all torques are one, but for rounding.
CurveSearch::Node CurveSearch::scanned(double speed, Trail& trail) const {
  Node n = node(speed, &trail, kScanAccuracy);
  if (n.plateau && nodes_.front().plateau) n.torque = nodes_.front().torque;
  return n.ok() && std::fabs(n.torque) < 1e3 * kScanAccuracy * holding_ ? node(speed, &trail) : n;
}

CurveSearch::Node CurveSearch::answered(double speed, Trail* trail) const {
  const Node n = node(speed, trail);
  if (!n.ok()) throw SearchFailure{n.status};
  return n;
}

// A node of a halving. Speeds without a periodic state, each followed up to its limit, may lie close
// together, and so may jumps, of which far from any motor rounding makes as many as there are numbers: then the search ends
// with a status.
const CurveSearch::Node& CurveSearch::halved(double speed) {
  if (halved_.size() >= kMostHalved) throw SearchFailure{MetricStatus::unresolved};
  const auto [place, fresh] = halved_.try_emplace(speed);
  if (fresh) place->second = node(speed);
  lost_ += place->second.lost;
  if (lost_ > kMostLost) throw SearchFailure{place->second.status};
  return place->second;
}

double CurveSearch::stall_torque() {
  if (nodes_.empty()) nodes_.push_back(answered(0));
  return nodes_.front().torque;
}

void CurveSearch::require_drive() {
  if (!(stall_torque() > 0)) throw SearchFailure{MetricStatus::undefined};
}

// A layer that slips all through at one speed does so at every lower one: halving finds the last node on
// the plateau, and of those before only the one at rest is kept. Returns the nodes met beyond, the
// slowest last.
std::vector<CurveSearch::Node> CurveSearch::skip_plateau(double step, Trail& trail) {
  int low = 0, high = kIntervals;
  std::vector<Node> on_plateau, beyond;
  while (high - low > 1) {
    const int middle = (low + high + 1) / 2;
    const Node next = scanned(middle * step, trail);
    if (!next.ok()) throw SearchFailure{next.status};
    (next.plateau ? low : high) = middle;
    next.plateau ? on_plateau.assign(1, next) : beyond.push_back(next);
  }
  nodes_.insert(nodes_.end(), on_plateau.begin(), on_plateau.end());
  return beyond;
}

// Nodes from rest to the first speed at which the torque is not positive. Points without an answer, as layers
// without damping or with mu_0 > mu may have, are passed over, as long as they do not follow one another.
void CurveSearch::scan() {
  if (scan_failure_) throw SearchFailure{*scan_failure_};
  if (scanned_) return;
  require_drive();
  try {
    double step = crest_ / (rough_ ? kRoughIntervals : kIntervals);
    int missing = 0;
    Trail trail;
    std::vector<Node> known;
    if (!rough_ && forgets_a_turn(m_) && starts_on_plateau()) known = skip_plateau(step, trail);
    for (double speed = nodes_.back().speed + step; nodes_.back().torque > 0; speed += step) {
      if (speed > kFarthest * crest_) throw SearchFailure{MetricStatus::unresolved};
      if (speed > 2 * crest_) step *= 1.5;
      Node next;
      if (!known.empty() && known.back().speed < speed + 0.5 * step) {
        next = known.back();
        known.pop_back();
      } else {
        next = scanned(speed, trail);
      }
      missing = next.ok() ? 0 : missing + 1;
      if (missing > kMissing) throw SearchFailure{next.status};
      if (next.ok()) nodes_.push_back(next);
    }
    scanned_ = true;
  } catch (const SearchFailure& failure) {
    scan_failure_ = failure.status;
    throw;
  }
}

// The zero of a smooth stretch by inverse interpolation; nothing if that does not settle at once.
std::optional<double> CurveSearch::zero_near(double torque, const Node& low,
                                             const Node& high) const {
  Trail trail;
  trail.add(low.speed, low.start);
  trail.add(high.speed, high.start);
  InverseInterpolation line(crest_, 1e-16);
  line.add(low.speed, low.torque - torque);
  line.add(high.speed, high.torque - torque);
  for (int i = 0; i < 8; ++i) {
    const double speed = line.zero();
    if (!(speed > low.speed && speed < high.speed)) return {};
    if (line.settled()) return speed;
    const double excess = answered(speed, &trail).torque - torque;
    if (excess == 0) return speed;
    line.add(speed, excess);
  }
  return {};
}

Crossing CurveSearch::falls_through(double torque, const Node& low, const Node& high) const {
  if (!rough_) {
    if (const std::optional<double> zero = zero_near(torque, low, high)) return {*zero, false};
  }
  std::vector<std::pair<double, double>> seen{{low.speed, low.torque - torque},
                                              {high.speed, high.torque - torque}};
  const auto excess = [&](double speed) {
    return seen.emplace_back(speed, answered(speed).torque - torque).second;
  };
  const Bracket b = close_in(excess, low.speed, high.speed, seen[0].second, seen[1].second);
  const auto at = [&seen](double speed) {
    return std::find_if(seen.begin(), seen.end(),
                        [speed](const auto& s) { return s.first == speed; })
        ->second;
  };
  const double at_low = at(b.low), at_high = at(b.high);
  const bool jump = at_low - at_high > 1e-7 * holding_;
  return {std::fabs(at_low) <= std::fabs(at_high) || jump ? b.low : b.high, jump};
}

Crossing CurveSearch::no_load() {
  if (no_load_) return *no_load_;
  if (!(stall_torque() > 0)) return *(no_load_ = Crossing{0, false});
  scan();
  const std::size_t last = nodes_.size() - 1;
  return *(no_load_ = falls_through(0, nodes_[last - 1], nodes_[last]));
}

Crossing CurveSearch::speed_at(double torque) {
  if (torque == 0) return no_load();
  if (!(torque > 0) || !(stall_torque() > 0)) throw SearchFailure{MetricStatus::unreachable};
  const Peak top = max_torque();
  const double carried =
      torque * (1 - 1e-12);  // a torque typed with rounding, such as the stall torque itself
  if (!(carried <= top.value)) throw SearchFailure{MetricStatus::unreachable};
  const bool plateau_is_top = top.kind == PeakKind::rest && starts_on_plateau();
  if (plateau_is_top && torque >= stall_torque() * (1 - kSameTorque)) return {plateau_end(), false};
  // From rest torque falls; elsewhere it may rise to its largest value, and jump.
  if (torque >= top.value) return {top.speed, top.kind != PeakKind::rest};
  // Torque may jump past it where it jumps past zero.
  if (no_load().slopeless && working_nodes().back().torque >= torque) return no_load();
  const std::vector<Node> nodes = nodes_around(torque);
  std::size_t k = after_last(nodes, torque);
  if (k > 0 && nodes[k - 1].speed >= top.speed)
    return falls_through(torque, nodes[k - 1], nodes[k]);
  // No node beyond the maximum carries it: it is met between the maximum and the first of them.
  while (k < nodes.size() && nodes[k].speed <= top.speed) ++k;
  const Node at_top = answered(top.speed);
  if (k < nodes.size() && at_top.torque > torque) return falls_through(torque, at_top, nodes[k]);
  return {top.speed, true};  // beside a jump
}

bool CurveSearch::starts_on_plateau() {
  stall_torque();
  return nodes_.front().plateau;
}

double CurveSearch::plateau_end() {
  if (plateau_end_) return *plateau_end_;
  if (!(stall_torque() > 0) || !starts_on_plateau()) return *(plateau_end_ = 0.0);
  scan();
  std::size_t k = 1;
  while (nodes_[k].plateau) ++k;
  const double hair = 1e-4 * crest_;  // nodes are not exact
  double low = std::max(nodes_[k - 1].speed - hair, 0.0), high = nodes_[k].speed + hair,
         speed = low;
  for (int i = 0; i < 60; ++i) {
    const Margin margin = plateau_margin(m_, speed);
    (margin.value > 0 ? low : high) = speed;
    double next = speed - margin.value / margin.slope;
    const bool inside = next >= low && next <= high;
    if (!inside) next = 0.5 * (low + high);
    const double step = std::fabs(next - speed);
    speed = next;
    // The margin is nearly linear in speed: after a step of 1e-9 the next would be lost in rounding.
    if ((inside && step <= 1e-9 * crest_) || high - low <= 1e-15 * crest_) break;
  }
  // With mu_0 > mu the layer may hold on to sticking where slipping all through would be possible too.
  if (rough_ && !node(speed * (1 - 1e-9)).plateau) {
    low = nodes_[k - 1].speed, high = speed, lost_ = 0;
    while (high - low > 1e-15 * crest_) {
      const double middle = 0.5 * (low + high);
      (halved(middle).plateau ? low : high) = middle;
    }
    speed = low;
  }
  return *(plateau_end_ = speed);
}

// Nodes within [0, no-load] where one may look for a torque. With mu_0 > mu it may jump up between two nodes
// that carry less: beyond the last one that carries it the ends of stretches are nodes as well.
std::vector<CurveSearch::Node> CurveSearch::nodes_around(double torque) {
  const std::vector<Node> nodes = working_nodes();
  if (!rough_) return nodes;
  lost_ = 0;
  const std::size_t from = std::max<std::size_t>(after_last(nodes, torque), 1) - 1;
  std::vector<Node> all(nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(from) + 1);
  for (std::size_t k = from + 1; k < nodes.size(); ++k) {
    if (std::max(nodes[k - 1].torque, nodes[k].torque) >= kWorth * torque) {
      for (const Stretch& stretch : stretches(nodes[k - 1], nodes[k]))
        for (const Node& each : {stretch.first, stretch.last})
          if (each.ok() && each.speed > all.back().speed) all.push_back(each);
    } else {
      all.push_back(nodes[k]);
    }
  }
  return all;
}

// Position after the last node that carries a torque; 0 if none does.
std::size_t CurveSearch::after_last(const std::vector<Node>& nodes, double torque) {
  std::size_t k = nodes.size() - 1;
  while (k > 0 && !(nodes[k - 1].torque >= torque)) --k;
  return k;
}

// Nodes within [0, no-load], the last one at no-load.
std::vector<CurveSearch::Node> CurveSearch::working_nodes() {
  scan();
  std::vector<Node> nodes(nodes_.begin(), nodes_.end() - 1);
  const double end = no_load().speed;
  if (!(end > nodes.back().speed)) return nodes;
  nodes.push_back(rough_ ? answered(end) : nodes_.back());
  if (!rough_) nodes.back().speed = end, nodes.back().torque = 0;
  return nodes;
}

}  // namespace twum::performance
