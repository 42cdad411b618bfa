// SPDX-License-Identifier: Apache-2.0
#include "performance/curve_search.hpp"

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>

namespace twum::performance {
namespace {

// Intervals between rest and the crest speed. Between two of them torque is taken to have no more than
// one maximum (with mu_0 > mu: one in each stretch with the same sequence of zones).
constexpr int kIntervals = 20;
constexpr int kRoughIntervals = 40;
constexpr int kMissing = 4;    // points without a periodic state that may follow one another
constexpr int kStretches = 8;  // sequences of zones between two nodes
constexpr double kInset =
    1e-7;  // share of a stretch left out at its ends, which stand for themselves
constexpr double kFarthest = 1e4;  // times the crest speed

struct Bracket {
  double low, high;
};

// Closes in on a sign change to neighbouring doubles, or to an exact zero.
template <typename F>
Bracket close_in(const F& f, double low, double high, double f_low, double f_high) {
  if (f_low == 0) return {low, low};
  if (f_high == 0) return {high, high};
  if (!((f_low < 0) != (f_high < 0)) || std::isnan(f_low) || std::isnan(f_high)) {
    throw SearchFailure{MetricStatus::unresolved};
  }
  boost::uintmax_t limit = 120;
  const auto found = boost::math::tools::toms748_solve(
      f, low, high, f_low, f_high, boost::math::tools::eps_tolerance<double>(51), limit);
  return {found.first, found.second};
}

}  // namespace

MetricStatus metric_status(PointStatus status) {
  switch (status) {
    case PointStatus::ok: return MetricStatus::ok;
    case PointStatus::no_periodic_state: return MetricStatus::no_periodic_state;
    case PointStatus::not_converged: return MetricStatus::not_converged;
    case PointStatus::resonance: return MetricStatus::resonance;
    case PointStatus::unresolved: return MetricStatus::unresolved;
  }
  return MetricStatus::unresolved;
}

CurveSearch::CurveSearch(const MotorModel<double>& model)
    : m_(model),
      holding_(model.static_ * model.preload * model.r),
      crest_(model.crest_velocity / model.r),
      rough_(model.static_ > model.kinetic) {}

CurveSearch::Node CurveSearch::node(double speed) const {
  const SolvedPoint p = solve_point(m_, speed);
  if (p.status != PointStatus::ok) return {speed, 0, 0, false, kNoState, metric_status(p.status)};
  const bool drives =
      !p.special && p.state.lap.one_slip && p.state.lap.first == ZoneState::slip_plus;
  return {speed,
          p.numbers.torque,
          p.numbers.stator_power,
          drives,
          p.special ? 0 : p.state.lap.itinerary,
          MetricStatus::ok};
}

CurveSearch::Node CurveSearch::answered(double speed) const {
  const Node n = node(speed);
  if (!n.ok()) throw SearchFailure{n.status};
  return n;
}

double CurveSearch::stall_torque() {
  if (nodes_.empty()) nodes_.push_back(answered(0));
  return nodes_.front().torque;
}

void CurveSearch::require_drive() {
  if (!(stall_torque() > 0)) throw SearchFailure{MetricStatus::undefined};
}

// Nodes from rest to the first speed at which the torque is not positive. With mu_0 > mu points without
// a periodic state are passed over, as long as they do not follow one another.
void CurveSearch::scan() {
  if (scan_failure_) throw SearchFailure{*scan_failure_};
  if (scanned_) return;
  require_drive();
  try {
    double step = crest_ / (rough_ ? kRoughIntervals : kIntervals);
    int missing = 0;
    for (double speed = step; nodes_.back().torque > 0; speed += step) {
      if (speed > kFarthest * crest_) throw SearchFailure{MetricStatus::unresolved};
      if (speed > 2 * crest_) step *= 1.5;
      const Node next = node(speed);
      missing = next.ok() ? 0 : missing + 1;
      if (missing > (rough_ ? kMissing : 0)) throw SearchFailure{next.status};
      if (next.ok()) nodes_.push_back(next);
    }
    scanned_ = true;
  } catch (const SearchFailure& failure) {
    scan_failure_ = failure.status;
    throw;
  }
}

Crossing CurveSearch::falls_through(double torque, const Node& low, const Node& high) const {
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
  const std::vector<Node> nodes = working_nodes();
  std::size_t k = nodes.size() - 1;
  while (k > 0 && !(nodes[k - 1].torque >= torque)) --k;
  const double high = nodes[k].speed;
  if (k > 0 && nodes[k - 1].speed >= top.speed)
    return falls_through(torque, nodes[k - 1], nodes[k]);
  if (top.kind == PeakKind::rest && starts_on_plateau()) return {plateau_end(), false};
  if (torque >= top.value || top.speed >= high) return {top.speed, false};
  if (const Node at_top = answered(top.speed); at_top.torque > torque)
    return falls_through(torque, at_top, nodes[k]);
  return {top.speed, top.kind != PeakKind::smooth};
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
  double low = nodes_[k - 1].speed, high = nodes_[k].speed, speed = low;
  for (int i = 0; i < 60; ++i) {
    const Margin margin = plateau_margin(m_, speed);
    (margin.value > 0 ? low : high) = speed;
    double next = speed - margin.value / margin.slope;
    if (!(next >= low && next <= high)) next = 0.5 * (low + high);
    const double step = std::fabs(next - speed);
    speed = next;
    if (step <= 1e-15 * crest_ || high - low <= 1e-15 * crest_) break;
  }
  // With mu_0 > mu the layer may hold on to sticking where slipping all through would be possible too.
  if (rough_ && !node(speed * (1 - 1e-9)).plateau) {
    low = nodes_[k - 1].speed, high = speed;
    while (high - low > 1e-15 * crest_) {
      const double middle = 0.5 * (low + high);
      (node(middle).plateau ? low : high) = middle;
    }
    speed = low;
  }
  return *(plateau_end_ = speed);
}

double CurveSearch::value(Goal goal, const Node& n) const {
  switch (goal) {
    case Goal::torque: return n.torque;
    case Goal::power: return n.torque * n.speed;
    case Goal::efficiency: break;
  }
  const double velocity = m_.omega * m_.amplitude;
  return n.torque * n.speed / (n.stator_power + m_.stator_damping * velocity * velocity);
}

const TorqueSlope& CurveSearch::torque_slope_at(double speed) {
  for (const auto& [at, kept] : slopes_) {
    if (at == speed) return kept;
  }
  const TorqueSlope t = torque_slope(m_, speed);
  if (t.status != PointStatus::ok) throw SearchFailure{metric_status(t.status)};
  return slopes_.emplace_back(speed, t).second;
}

CurveSearch::Sloped CurveSearch::sloped(Goal goal, double speed) {
  const TorqueSlope& t = torque_slope_at(speed);
  const double power = t.torque * speed, power_slope = t.torque + speed * t.slope;
  switch (goal) {
    case Goal::torque: return {t.torque, t.slope};
    case Goal::power: return {power, power_slope};
    case Goal::efficiency: break;
  }
  const double velocity = m_.omega * m_.amplitude;
  const double input = t.stator_power + m_.stator_damping * velocity * velocity;
  return {power / input, (power_slope * input - power * t.power_slope) / (input * input)};
}

// Nodes within [0, no-load], the last one at no-load.
std::vector<CurveSearch::Node> CurveSearch::working_nodes() {
  scan();
  std::vector<Node> nodes(nodes_.begin(), nodes_.end() - 1);
  const double end = no_load().speed;
  if (end > nodes.back().speed) nodes.push_back(answered(end));
  return nodes;
}

// A maximum in an interval where the slope goes from + to -; nothing if it does not.
std::optional<Peak> CurveSearch::peak_between(Goal goal, double low, double high) {
  const auto slope = [&](double speed) { return sloped(goal, speed).slope; };
  if (!(low < high)) return {};
  double at_low = slope(low), at_high = slope(high);
  if (!(at_low > 0)) return {};
  // A dip behind the maximum can hide it: halve towards the higher side.
  if (!(at_high < 0) && !(sloped(goal, high).value < sloped(goal, low).value)) return {};
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

// The secant method on the slope, from the vertex of the parabola through three nodes. Mostly four
// points; nothing if it does not settle at once inside the nodes, as at a kink.
std::optional<Peak> CurveSearch::peak_near(Goal goal, const Node& a, const Node& b, const Node& c) {
  const double fa = value(goal, a), fb = value(goal, b), fc = value(goal, c);
  const double left = (fb - fa) / (b.speed - a.speed), right = (fc - fb) / (c.speed - b.speed);
  double curvature = 2 * (right - left) / (c.speed - a.speed);
  double speed = 0.5 * (a.speed + b.speed) - left / curvature;
  Sloped s{0, 0};
  double last_speed = speed, last_slope = 0;
  for (int i = 0; i < 8; ++i) {
    if (!(speed > a.speed && speed < c.speed)) return {};
    s = sloped(goal, speed);
    if (i > 0 && speed != last_speed) curvature = (s.slope - last_slope) / (speed - last_speed);
    if (!(curvature < 0)) return {};
    last_speed = speed, last_slope = s.slope;
    const double step = -s.slope / curvature;
    if (std::fabs(step) <= 1e-10 * crest_) return Peak{speed, s.value, PeakKind::smooth};
    speed += step;
  }
  return {};
}

Peak CurveSearch::named(Peak peak) {
  if (peak.kind == PeakKind::kink && starts_on_plateau() &&
      std::fabs(peak.speed - plateau_end()) <= 1e-8 * crest_) {
    peak.kind = PeakKind::plateau_end;
    peak.speed = plateau_end();
  }
  return peak;
}

Peak CurveSearch::smooth_peak(Goal goal, const std::vector<Node>& nodes, std::size_t top) {
  const Peak at_node{nodes[top].speed, value(goal, nodes[top]),
                     top == 0 ? PeakKind::rest : PeakKind::smooth};
  if (nodes.size() == 1) return at_node;
  if (top > 0 && top + 1 < nodes.size()) {
    const std::optional<Peak> near = peak_near(goal, nodes[top - 1], nodes[top], nodes[top + 1]);
    if (near && near->value >= at_node.value) return *near;
  }
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
  const double worth = 0.7 * best.value;
  for (std::size_t k = 0; k + 1 < nodes.size(); ++k) {
    if (std::max(value(goal, nodes[k]), value(goal, nodes[k + 1])) < worth) continue;
    Node low = nodes[k];
    const Node end = nodes[k + 1];
    for (int stretch = 0; stretch < kStretches; ++stretch) {
      // Where zones are born, rounding can tell many sequences apart: the rest counts as one stretch.
      const bool rest = low.itinerary == end.itinerary || stretch + 1 == kStretches;
      const auto [left, right] = rest ? std::pair(end, end) : stretch_end(low, end);
      const bool level = goal == Goal::torque && low.plateau;
      if (low.ok() && !level) {
        // A zone that is just born has an end without slope: look for the maximum a little inside.
        const double inset = kInset * (left.speed - low.speed);
        const std::optional<Peak> inside =
            peak_between(goal, low.speed + inset, left.speed - inset);
        if (inside && inside->value > best.value) best = *inside;
      }
      consider(left);
      consider(right);
      if (right.speed >= end.speed) break;
      low = right;
    }
  }
  return named(best);
}

// Neighbouring speeds between which the sequence of zones that holds at `low` ends.
std::pair<CurveSearch::Node, CurveSearch::Node> CurveSearch::stretch_end(const Node& low,
                                                                         const Node& end) const {
  Node left = low, right = end;
  while (right.speed - left.speed > 4e-16 * (crest_ + right.speed)) {
    const Node middle = node(0.5 * (left.speed + right.speed));
    if (middle.speed <= left.speed || middle.speed >= right.speed) break;
    (middle.itinerary == low.itinerary ? left : right) = middle;
  }
  return {left, right};
}

Peak CurveSearch::peak(Goal goal) {
  std::optional<Peak>& kept = peaks_[static_cast<int>(goal)];
  if (kept) return *kept;
  require_drive();
  // |T| <= mu F_N r: a motor that stalls on its plateau cannot do better.
  if (goal == Goal::torque && !rough_ && starts_on_plateau()) {
    return *(kept = Peak{0, stall_torque(), PeakKind::rest});
  }
  const std::vector<Node> nodes = working_nodes();
  std::size_t top = 0;
  for (std::size_t k = 1; k < nodes.size(); ++k) {
    if (value(goal, nodes[k]) > value(goal, nodes[top])) top = k;
  }
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

Peak CurveSearch::max_efficiency() {
  if (!(m_.stator_damping > 0)) throw SearchFailure{MetricStatus::undefined};
  return peak(Goal::efficiency);
}

}  // namespace twum::performance
