// SPDX-License-Identifier: Apache-2.0
#include "contact/jump.hpp"

#include "contact/lap.hpp"
#include "contact/periodic_state.hpp"
#include "contact/zone_curves.hpp"
#include "contact/zone_start.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace twum::inline v0_1::contact {
namespace {

constexpr double kParted = 1e-3;  // of the contact's half, more than the ends of zones move
constexpr int kMostTurns = 200;
constexpr int kMostTurnsToMove = 30;
constexpr double kSame = 1e-16;  // of P

// Zone by zone.
using Trace = core::Vector<ZoneTrace>;

// Sign of the traction that has released a layer. An elastic layer may stick again at once, at what is left of it.
double side_of(const ZoneTrace& after) {
  if (after.zone.state != ZoneState::stick) return -sign_of(after.zone.state);
  return after.start.e < 0 ? -1 : 1;
}

bool comes_back(const LapEntry<double>& from, const LapEntry<double>& to) {
  return std::fabs(to.layer.e - from.layer.e) + std::fabs(to.layer.rate - from.layer.rate) <= kSame;
}

// Where two laps part; nothing if they do not.
std::optional<Jump> parting(const Trace& a, const Trace& b, int turn) {
  if (a.empty() || b.empty()) return {};
  const double exit = a.back().zone.to, parted = kParted * exit;
  const std::size_t common = std::min(a.size(), b.size());
  for (std::size_t k = 0; k < common; ++k) {
    const Zone &p = a[k].zone, &q = b[k].zone;
    const int zone = static_cast<int>(k);
    if (exit - p.from < parted) return {};  // what begins at the exit begins with no length
    if (p.state != q.state) {
      const ZoneState slips = p.state == ZoneState::stick ? q.state : p.state;
      return Jump{k == 0 ? Jump::Kind::at_entry : Jump::Kind::at_start, turn, zone, -sign_of(slips),
                  p.from};
    }
    if (std::fabs(p.to - q.to) < parted) continue;
    const Trace& first = p.to < q.to ? a : b;
    const double place = std::min(p.to, q.to);
    if (p.state != ZoneState::stick)
      return Jump{Jump::Kind::in_slip, turn, zone, sign_of(p.state), place};
    if (k + 1 == first.size()) return {};
    return Jump{Jump::Kind::in_stick, turn, zone, side_of(first[k + 1]), place};
  }
  return {};
}

std::optional<Jump> jump_from_rest(const ContactNumbers<double>& a,
                                   const ContactNumbers<double>& b) {
  const LayerMotion<double> at_a(a.inertia, a.damping), at_b(b.inertia, b.damping);
  LapEntry<double> from_a{{0, 0}}, from_b{{0, 0}};
  Trace trace_a, trace_b;
  for (int turn = 0; turn < kMostTurns; ++turn) {
    trace_a.clear(), trace_b.clear();
    const Lap<double> lap_a = run_lap(a, at_a, from_a, nullptr, &trace_a, Means::of_wave),
                      lap_b = run_lap(b, at_b, from_b, nullptr, &trace_b, Means::of_wave);
    if (lap_a.status != LapStatus::ok || lap_b.status != LapStatus::ok) return {};
    if (const auto jump = parting(trace_a, trace_b, turn)) return jump;
    if (comes_back(from_a, lap_a.next) && comes_back(from_b, lap_b.next)) return {};
    from_a = lap_a.next, from_b = lap_b.next;
  }
  return {};
}

// After so many turns from a fixed state the derivatives are those of the periodic state: the free flights have damped all else to
// rounding.
int turns_to_move(const ContactNumbers<double>& n, const LayerMotion<double>& layer) {
  const double left_by_turn = layer.slowest_decay() * 2 * (std::numbers::pi - n.half_angle);
  const double turns = std::ceil(-std::log(kSame) / left_by_turn);
  return turns < kMostTurnsToMove ? static_cast<int>(turns) : kMostTurnsToMove;
}

// Newton's method may find a periodic state where laps from rest lead to another one: then it is its own end that counts.
std::optional<Jump> end_of_state(const ContactNumbers<double>& a, const ContactNumbers<double>& b) {
  const LayerMotion<double> at_a(a.inertia, a.damping), at_b(b.inertia, b.damping);
  const PeriodicState state = find_periodic_state(a, at_a);
  if (state.status != PeriodicStatus::ok || !state.remembers) return {};
  Trace trace_a, trace_b;
  run_lap(a, at_a, state.entry, nullptr, &trace_a, Means::of_wave);
  run_lap(b, at_b, state.entry, nullptr, &trace_b, Means::of_wave);
  std::optional<Jump> jump = parting(trace_a, trace_b, turns_to_move(a, at_a));
  if (jump) jump->entry = state.entry;
  return jump;
}

}  // namespace

std::optional<Jump> jump_between(const ContactNumbers<double>& a, const ContactNumbers<double>& b) {
  if (const auto jump = jump_from_rest(a, b)) return jump;
  std::optional<Jump> end = end_of_state(a, b);
  if (end) end->beside = -1;
  if (!end && (end = end_of_state(b, a))) end->beside = 1;
  return end;
}

namespace {

// Newton's method, from a place that is off by the root of how far two contacts are from their jump.
constexpr int kExtremumSteps = 6;

// A function with its derivatives along the phase.
template <typename S>
struct Extremum {
  S f, f1, f2;
};

// sigma v_rel along a slip zone (E2.2).
template <typename S>
class SlipAlong {
 public:
  SlipAlong(const ContactNumbers<S>& n, const LayerMotion<S>& layer, const LapPlace<S>& from,
            double sigma)
      : layer_(layer), sigma_(sigma), from_(from.theta) {
    const Harmonic<S> f = forced_response(n, layer, sigma);
    slow_ = relative_rate(n, f);
    motion_ = layer.start(layer.own_part(
        {from.layer.e - f.at(from.theta, from.at), from.layer.rate - f.slope(from.at)}));
  }

  S at(const S& theta) const {
    return sigma_ * (slow_.at(theta, trig(theta)) + layer_.at(motion_, S(theta - from_)).rate);
  }
  Extremum<S> with_slopes(const S& theta) const {
    const Trig<S> a = trig(theta);
    const LayerState<S> h = layer_.at(motion_, S(theta - from_));
    const S rate2 = rate_of(h.e, h.rate), rate3 = rate_of(h.rate, rate2);
    return {sigma_ * (slow_.at(theta, a) + h.rate), sigma_ * (slow_.slope(a) + rate2),
            sigma_ * (slow_.curvature(a) + rate3)};
  }

 private:
  // M e'' of the layer's own motion is -C e' - e.
  S rate_of(const S& e, const S& rate) const {
    if (layer_.kind() == LayerKind::elastic) return S(0.0);
    return layer_.kind() == LayerKind::relaxing ? S(-rate / layer_.C)
                                                : S(-(layer_.C * rate + e) / layer_.M);
  }

  const LayerMotion<S>& layer_;
  double sigma_;
  S from_;
  Harmonic<S> slow_;
  FreeMotion<S> motion_;
};

// What the traction of a stick zone leaves to its threshold on one side (E2.4).
template <typename S>
struct ReserveAlong {
  Harmonic<S> f;

  S at(const S& theta) const { return f.at(theta, trig(theta)); }
  Extremum<S> with_slopes(const S& theta) const {
    const Trig<S> a = trig(theta);
    return {f.at(theta, a), f.slope(a), f.curvature(a)};
  }
};

template <typename S, typename Along>
S towards_extremum(const Along& along, const S& theta) {
  const Extremum<S> at = along.with_slopes(theta);
  return theta - at.f1 / at.f2;
}

// What visit(function) says of the function that touches zero at the jump; where a zone begins with it, its value there.
template <typename S, typename Visit>
S at_jump(const ContactNumbers<S>& n, const Jump& jump, Visit visit) {
  const LayerMotion<S> layer(n.inertia, n.damping);
  LapEntry<S> entry = constant_entry<S>(jump.entry);
  for (int turn = 0; turn < jump.turn; ++turn)
    entry = run_lap(n, layer, entry, nullptr, nullptr, Means::of_wave).next;
  const LapPlace<S> from = place_after(jump.zone, n, layer, entry);
  if (jump.kind == Jump::Kind::in_slip) return visit(SlipAlong<S>(n, layer, from, jump.side));
  const Harmonic<S> t = sticking_traction(n, layer, from, from.layer.e);
  if (jump.kind == Jump::Kind::at_entry && !n.full)
    return n.kinetic * n.edge.sin - jump.side * t.slope(from.at);
  const ReserveAlong<S> along{reserve(n, t, jump.side)};
  return jump.kind == Jump::Kind::in_stick ? visit(along) : along.f.at(from.theta, from.at);
}

double least_place(const ContactNumbers<double>& n, const Jump& jump) {
  return at_jump(n, jump, [&](const auto& along) {
    double theta = jump.place;
    for (int i = 0; i < kExtremumSteps; ++i) theta = towards_extremum(along, theta);
    return theta;
  });
}

}  // namespace

// The first derivatives of the least value do not feel that its place moves; the second ones feel how it does.
template <typename S>
S jump_margin(const ContactNumbers<S>& numbers, const Jump& jump) {
  const bool touches = jump.kind == Jump::Kind::in_slip || jump.kind == Jump::Kind::in_stick;
  const double place = touches ? least_place(values_of(numbers), jump) : 0;
  return at_jump(numbers, jump, [place](const auto& along) {
    S theta(place);
    if constexpr (kDualDepth<S> == 2) theta = towards_extremum(along, theta);
    return along.at(theta);
  });
}

#define TWUM_INSTANTIATE(S) template S jump_margin(const ContactNumbers<S>&, const Jump&);
TWUM_FOR_EACH_MARGIN_SCALAR(TWUM_INSTANTIATE)
#undef TWUM_INSTANTIATE

}  // namespace twum::inline v0_1::contact
