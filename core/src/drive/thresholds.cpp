// SPDX-License-Identifier: Apache-2.0
#include "drive/thresholds.hpp"

#include "curve/curve.hpp"

#include <twum/base/error.hpp>
#include <twum/base/scalar_search.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace twum::inline v0_1::core {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

std::size_t place_of(Metric metric) {
  switch (metric) {
    case Metric::start_voltage: return 0;
    case Metric::hold_voltage: return 1;
    case Metric::start_frequency: return 2;
    default: TWUM_ASSERT(metric == Metric::pull_out_frequency); return 3;
  }
}

// The highest maximum or the lowest minimum.
std::optional<ForceExtremum> outermost(const Vector<ForceExtremum>& extrema, bool start) {
  std::optional<ForceExtremum> best;
  for (const ForceExtremum& e : extrema) {
    if (e.maximum != start) continue;
    if (!best || (e.force > best->force) == start) best = e;
  }
  return best;
}

// A start has to pass the maximum from which H falls most, a running wave ends at the minimum to which it does. H may have more of
// them where it rises: ripples, and jumps by parts of a per cent far beyond the running wave.
std::optional<ForceExtremum> chosen(const Vector<ForceExtremum>& extrema, bool start) {
  const ForceExtremum *from = nullptr, *to = nullptr, *highest = nullptr;
  for (const ForceExtremum& e : extrema) {
    if (e.maximum && (!highest || e.force > highest->force)) highest = &e;
    if (e.maximum || !highest) continue;
    if (!from || highest->force / e.force > from->force / to->force) from = highest, to = &e;
  }
  if (!from) return outermost(extrema, start);
  return start ? *from : *to;
}

// Beyond all folds on the other side a stable wave goes on without end.
bool is_past_folds(const Vector<CurveNode>& nodes, bool upward) {
  if (!(nodes.back().rise > 0) || (nodes.back().along.y > 0) == upward) return false;
  const auto beyond = [&](const CurveNode& n) {
    return !n.fold || (nodes.back().at.y > n.at.y) != upward;
  };
  return std::all_of(nodes.begin(), nodes.end(), beyond);
}

}  // namespace

Thresholds::Thresholds(const MotorDesign& design, const TrackRule& track,
                       std::optional<Vector<ForceExtremum>> extrema, const CurveNode* at_rest)
    : waves_(design, track),
      given_voltage_(design.stator.voltage.has_value()),
      frequency_(drive_frequency(design)),
      extrema_(std::move(extrema)),
      at_rest_(at_rest) {}

const Threshold& Thresholds::at(Metric metric) {
  std::optional<Threshold>& kept = found_[place_of(metric)];
  if (kept) return *kept;
  switch (metric) {
    case Metric::start_voltage: kept = voltage(true); break;
    case Metric::hold_voltage: kept = voltage(false); break;
    default: kept = frequency(metric == Metric::start_frequency);
  }
  return *kept;
}

DrivenWaves Thresholds::waves_at(double frequency) const {
  return waves_.at_frequency(kTurn * frequency);
}

const Vector<ForceExtremum>& Thresholds::extrema() {
  if (!extrema_) extrema_ = ForceLine(waves_, 0).extrema();
  return *extrema_;
}

// Where H has no extremum there is one wave at every voltage.
Threshold Thresholds::voltage(bool start) {
  const std::optional<ForceExtremum> e = chosen(extrema(), start);
  if (!e) return {0, 0, frequency_};
  return {waves_.modes().rms_voltage(e->force), e->amplitude, frequency_, e->beyond_kink};
}

Threshold Thresholds::frequency(bool start) {
  if (!given_voltage_ || !(waves_.omega() > waves_.resonance()))
    throw SearchFailure{MetricStatus::undefined};
  if (waves_.has_static_excess()) {
    const auto found = jumping_frequency(start);
    if (!found) throw SearchFailure{MetricStatus::undefined};
    return *found;
  }
  std::optional<CurveNode> fold;
  if (const auto e = chosen(extrema(), start)) fold = continued(*e);
  if (!fold) {
    if (!followed_) follow_frequency();
    fold = start ? start_ : pull_out_;
  }
  if (!fold) throw SearchFailure{MetricStatus::undefined};
  const auto [lowest, highest] = waves_.own_side();  // beyond, a start needs less frequency (D8.7)
  if (fold->parameter < lowest || fold->parameter > highest)
    throw SearchFailure{MetricStatus::undefined};
  const double f = fold->parameter / kTurn;
  return {f, fold->amplitude, f, fold->beyond_kink};
}

// The fold continued in voltage and frequency together, from the design's own frequency to its voltage: Newton's method for H =
// Theta u_0 and H_A = 0 (D3.4). The derivatives of H are exact, those of H_A are learned from the steps; at first H_A keeps to the
// direction in which the amplitude goes like 1 / (f - f_r). Nothing unless that leads to an extremum of this kind.
std::optional<CurveNode> Thresholds::continued(const ForceExtremum& from) const {
  const ForcePlane plane = ForcePlane::of_frequency(waves_, 0);
  PlanePoint p{std::log(from.amplitude), plane.coordinate(waves_.omega())};
  PlanePoint row{from.bend, from.bend}, step{0, 0};
  double rise = 0;
  WarmStart start;
  for (int i = 0; i < kRules.most_newtons; ++i) {
    const bool rough = std::hypot(step.x, step.y) > kRules.short_secant || i == 0;
    ForcePlane::Value v =
        plane.at(p, i > 0 ? &start : nullptr, rough ? kRules.frequency.states : kRules.fold);
    if (!v.ok()) return {};
    if (i > 0) {
      const double missed =
          (v.in_x - rise - row.x * step.x - row.y * step.y) / (step.x * step.x + step.y * step.y);
      row = {row.x + missed * step.x, row.y + missed * step.y};
    }
    rise = v.in_x;
    const double determinant = v.in_x * row.y - v.in_y * row.x;
    step = {(v.in_y * rise - row.y * v.excess) / determinant,
            (row.x * v.excess - v.in_x * rise) / determinant};
    const double size = std::hypot(step.x, step.y),
                 share = std::fmin(1, kRules.longest_newton / size);
    step = {share * step.x, share * step.y};
    if (!std::isfinite(size)) return {};
    if (std::fabs(step.x) <= kRules.extremum && std::fabs(step.y) <= kRules.settled_fold) {
      const auto beyond = plane.at({p.x + kRules.probe, p.y}, nullptr, kRules.frequency.states);
      CurveNode fold = plane.node(std::move(v), p, step);
      return beyond.ok() && (beyond.in_x < 0) == from.maximum ? std::optional(std::move(fold))
                                                              : std::nullopt;
    }
    start = moved(v.start(), v.wave.states, std::exp(p.x + step.x) - std::exp(p.x),
                  plane.rate(p.y) * step.y);
    p = {p.x + step.x, p.y + step.y};
  }
  return {};
}

// The waves at rest over the frequency are one curve: from the dead wave at low frequencies up to the start, back to where the
// running one pulls out, and up again.
void Thresholds::follow_frequency() {
  followed_ = true;
  const double free = waves_.resonance();
  if (!at_rest_) return;
  const ForcePlane plane = ForcePlane::of_frequency(waves_, 0);
  const double stuck = std::sqrt(free * free + waves_.contact_stiffness() / waves_.modes().mass);
  const WaveCurve curve(plane,
                        {{-HUGE_VAL, plane.coordinate(free * (1 + kRules.nearest_frequency))},
                         {HUGE_VAL, plane.coordinate(2 * stuck)}},
                        kRules.frequency);
  const auto from =
      curve.solve_at({at_rest_->at.x, plane.coordinate(waves_.omega())}, &at_rest_->start);
  if (!from) return;
  const bool dead = !extrema().empty() && at_rest_->amplitude < extrema().back().amplitude;
  for (const bool upward : {dead, !dead}) {
    take_folds(curve.follow(*from, upward, [upward](const Vector<CurveNode>& nodes) {
      return is_past_folds(nodes, upward);
    }));
    if (start_ || pull_out_) return;
  }
}

// Where folds are close, the start is the highest maximum and the running wave ends at the lowest minimum.
void Thresholds::take_folds(const Vector<CurveNode>& nodes) {
  for (std::size_t i = 1; i + 1 < nodes.size(); ++i) {
    const CurveNode& fold = nodes[i];
    if (!fold.fold) continue;
    const bool ahead = nodes[i + 1].at.x > nodes[i - 1].at.x;
    const bool maximum = nodes[ahead ? i + 1 : i - 1].rise < 0;
    std::optional<CurveNode>& kept = maximum ? start_ : pull_out_;
    if (!kept || (fold.at.y > kept->at.y) == maximum) kept = fold;
  }
}

// The extremum of H falls with the frequency (D3.4). Between two frequencies it lies between the amplitudes that it has there; whether
// another one has passed it is seen at the end.
std::optional<Threshold> Thresholds::jumping_frequency(bool start) {
  const auto at = [&](double f, double lowest, double highest) {
    const DrivenWaves waves = waves_at(f);
    if (!(highest > 0)) return chosen(ForceLine(waves, 0).extrema(), start);
    const ForceLine nearby(waves, 0, lowest / kRules.island, highest * kRules.island);
    return outermost(nearby.extrema(), start);
  };
  const auto excess = [&](const std::optional<ForceExtremum>& e) {
    return e ? std::log(e->force / waves_.drive()) : -1.0;
  };
  const double free = waves_.resonance() / kTurn;
  double low = frequency_, high = frequency_;
  std::optional<ForceExtremum> at_low = chosen(extrema(), start), at_high = at_low;
  while (excess(at_low) < 0 && low - free > kRules.nearest_frequency * free)
    high = low, at_high = at_low, low = free + (low - free) / kRules.island, at_low = at(low, 0, 0);
  while (excess(at_high) > 0 && high < 2 * frequency_)
    low = high, at_low = at_high, high = free + (high - free) * kRules.island,
    at_high = at(high, 0, 0);
  if (!(excess(at_low) > 0 && excess(at_high) < 0)) return {};
  const double lowest =
                   at_high ? std::fmin(at_low->amplitude, at_high->amplitude) : at_low->amplitude,
               highest =
                   at_high ? std::fmax(at_low->amplitude, at_high->amplitude) : at_low->amplitude;
  const auto between = [&](double f) { return excess(at(f, lowest, highest)); };
  const double root = closed_in("a jump of the force", between,
                                {low, high, excess(at_low), excess(at_high)}, kRules.jump_bits)
                          .nearest();
  const std::optional<ForceExtremum> e = at(root, 0, 0);
  if (!e || !(std::fabs(excess(e)) < kRules.jump)) return {};
  return Threshold{root, e->amplitude, root};
}

}  // namespace twum::inline v0_1::core
