// SPDX-License-Identifier: Apache-2.0
#include "contact/radial_state.hpp"

#include "contact/radial_lap.hpp"
#include "contact/radial_lock.hpp"
#include "contact/scalars.hpp"
#include "contact/small_system.hpp"
#include "contact/widened.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace twum::inline v0_1::contact {
namespace {

constexpr std::size_t kNumbers = 4;  // of the layer's state
using Matrix = SquareMatrix<kNumbers>;

constexpr int kMostLaps = 300;
constexpr double kAgreed = 1e-11;  // of mu_0 p(0): what laps of different steps differ by
constexpr double kRounded =
    1e-7;  // where no step comes nearer, this is good enough for the accuracy of a lap
constexpr double kForgotten = 1e-9;  // of a difference at entry
constexpr double kAgreement = 1e-6;  // of the integral of the friction power with the balance
constexpr double kSlowly = 0.02;     // a lap that leaves more of the gap calls for Newton's method

template <typename S>
std::array<S, kNumbers> listed(const LapEntry<S>& at) {
  return {at.layer.e, at.layer.rate, at.across.e, at.across.rate};
}
template <typename S>
void move(LapEntry<S>& at, const std::array<S, kNumbers>& to) {
  at.layer = {to[0], to[1]}, at.across = {to[2], to[3]};
}

template <typename S>
LapEntry<S> moving_entry(const LapEntry<double>& at) {
  return {
      {S(at.layer.e), S(at.layer.rate)}, at.carried, at.zone, {S(at.across.e), S(at.across.rate)}};
}

template <typename S>
ContactNumbers<S> constant(const ContactNumbers<double>& n) {
  return {n.inertia,     n.damping,    n.stick_rate,
          n.speed_ratio, n.half_angle, n.peak,
          n.kinetic,     n.threshold,  {n.edge.sin, n.edge.cos, n.edge.versine},
          n.full,        n.radial};
}

// 1 less the derivatives of the state at the next entry in that at this one (E6.2).
Factors<kNumbers> return_slope(const ContactNumbers<double>& n, const LapEntry<double>& at,
                               std::span<const RadialStep> steps) {
  LapEntry<PlaneDual> entry = moving_entry<PlaneDual>(at);
  entry.layer.e.d[0] = entry.layer.rate.d[1] = entry.across.e.d[2] = entry.across.rate.d[3] = 1;
  const auto next = listed(run_radial_lap(constant<PlaneDual>(n), entry, {steps}).next);
  Matrix m;
  for (std::size_t i = 0; i < kNumbers; ++i)
    for (std::size_t j = 0; j < kNumbers; ++j) m[i][j] = (i == j ? 1 : 0) - next[i].d[j];
  return Factors<kNumbers>(m);
}

// Newton's step to the fixed point of the return map.
template <typename S>
std::array<S, kNumbers> newton_step(const Factors<kNumbers>& slope, const LapEntry<S>& at,
                                    const LapEntry<S>& next) {
  std::array<S, kNumbers> gap = listed(next);
  const std::array<S, kNumbers> from = listed(at);
  for (std::size_t i = 0; i < kNumbers; ++i) gap[i] = gap[i] - from[i];
  return slope.solve(gap);
}

template <typename S>
void balance(const ContactNumbers<S>& n, ContactMeans<S>& m) {
  m.friction_power = m.stator_power - n.speed_ratio * m.traction - m.layer_loss;
}

class RadialSearch {
 public:
  RadialSearch(const ContactNumbers<double>& n, double accuracy, std::span<const RadialStep> known,
               PeriodicState& state)
      : n_(n),
        known_(known),
        s_(state),
        layer_(n.inertia, n.damping),
        scale_(n.threshold * n.peak) {
    tolerance_ = std::max(accuracy, kAgreed) * scale_;
  }

  void run(const LapGuess* guess) {
    const bool monotone = !(n_.threshold > n_.kinetic);
    LapEntry<double> from = n_.full ? nearly_locked() : LapEntry<double>{{0, 0}};
    if (guess && monotone && guess->carried == n_.full) from = *guess;
    turn(from);
    for (int same = 0; s_.laps < kMostLaps;) {
      if (s_.lap.status != LapStatus::ok) return give_up(PeriodicStatus::unresolved);
      if (gap_ <= tolerance_) return finish();
      const double before = gap_;
      const std::uint64_t itinerary = s_.lap.itinerary;
      const bool slow = s_.laps > 1 && progress_ > kSlowly;
      if (!(slow && (monotone || same > 3) && newton(monotone))) {
        if (slow && gap_ <= kRounded * scale_ && progress_ > 0.5) return finish();
        turn(sticks_all_round() ? after_drift() : s_.lap.next);
      }
      progress_ = gap_ / before;
      same = s_.lap.itinerary == itinerary ? same + 1 : 0;
    }
    give_up(monotone ? PeriodicStatus::not_converged : PeriodicStatus::no_periodic_state);
  }

 private:
  void turn(const LapEntry<double>& entry) {
    s_.entry = entry;
    s_.steps.clear();
    s_.lap = run_radial_lap(n_, entry, {known_, &s_.steps});
    ++s_.laps, s_.zones += s_.lap.zones;
    const LapEntry<double>& next = s_.lap.next;
    gap_ = std::hypot(distance(layer_, next.layer, entry.layer),
                      distance(layer_, next.across, entry.across));
    if (n_.full && (!entry.carried || entry.zone != next.zone)) gap_ = std::fmax(gap_, scale_);
  }

  bool newton(bool any_zones) {
    const LapEntry<double> from = s_.entry;
    const Lap<double> lap = s_.lap;
    const core::Vector<RadialStep> steps = s_.steps;
    const double gap = gap_;
    ++s_.laps;
    const std::array<double, kNumbers> step =
        newton_step(return_slope(n_, from, steps), from, lap.next);
    if (!std::isfinite(step[0] + step[1] + step[2] + step[3])) return false;
    for (double share = 1; share > 1e-3; share *= 0.25) {
      LapEntry<double> entry = from;
      entry.carried = n_.full, entry.zone = lap.next.zone;
      std::array<double, kNumbers> to = listed(from);
      for (std::size_t i = 0; i < kNumbers; ++i) to[i] += share * step[i];
      move(entry, to);
      turn(entry);
      const bool kept = any_zones || s_.lap.itinerary == lap.itinerary;
      if (s_.lap.status == LapStatus::ok && kept && gap_ < (1 - 0.5 * share) * gap) return true;
      if (!any_zones) break;
    }
    s_.entry = from, s_.lap = lap, s_.steps = steps, gap_ = gap;
    return false;
  }

  bool sticks_all_round() const {
    return n_.full && s_.entry.carried && s_.lap.zones == 1 && s_.lap.first == ZoneState::stick;
  }

  // In full contact, where a rotor that hardly turns leaves the layer, if it sticks all round at rest: tractions that only touch the
  // threshold come from nowhere else in few laps.
  LapEntry<double> nearly_locked() const {
    LapEntry<double> entry{{0, 0}, true, ZoneState::stick};
    const double side = n_.speed_ratio < 0 ? -1 : 1;
    const TouchingPhases touch = touching_phases(n_, side);
    if (!touch.exist) return entry;
    const double least = LockBound<double>{n_, side}(touch.theta[0], touch.across).at;
    entry.layer.e = side * least;
    entry.across.e = touch.across + n_.stick_rate * n_.radial;
    entry.layer.rate = -n_.stick_rate * (1 + n_.speed_ratio);
    return entry;
  }

  // A layer that sticks all round only drifts, by the same amount each lap (E6.3): half of the way to where its traction
  // reaches the threshold at once, as far as samples tell.
  LapEntry<double> after_drift() const {
    constexpr int kSamples = 64;
    const double s = n_.stick_rate, drift = -2 * std::numbers::pi * s * n_.speed_ratio;
    LapEntry<double> entry = s_.lap.next;
    double reserve = HUGE_VAL;
    for (int i = 0; i < kSamples; ++i) {
      const SinCos<double> a = twum::sincos(2 * std::numbers::pi * i / kSamples);
      const double rest = 1 - n_.inertia;
      const Plane<double> t{
          entry.layer.e + s * (rest * a.sin + n_.damping * (a.cos - n_.speed_ratio)),
          entry.across.e + s * n_.radial * (-1 - rest * a.cos + n_.damping * a.sin)};
      reserve = std::fmin(reserve, n_.threshold * (n_.peak - 1 + a.cos) - length(t));
    }
    const double laps = std::floor(0.5 * reserve / std::fabs(drift)) - 1;
    if (laps > 0 && std::isfinite(laps)) entry.layer.e += laps * drift;
    return entry;
  }

  // What goes in comes out (T7.10), so that the friction power follows from the rest; its own integral tells how far off the lap is.
  void finish() {
    const double friction = s_.lap.means.friction_power;
    balance(n_, s_.lap.means);
    const bool agree = std::fabs(s_.lap.means.friction_power - friction) <=
                       kAgreement * scale_ * (1 + std::fabs(n_.speed_ratio));
    s_.status = agree ? PeriodicStatus::ok : PeriodicStatus::unresolved;
    // What a difference leaves after the flight is less than a derivative is good for.
    const double flight = 2 * (std::numbers::pi - n_.half_angle);
    s_.remembers = n_.full || std::exp(-layer_.slowest_decay() * flight) > kForgotten;
  }
  void give_up(PeriodicStatus status) { s_.status = status; }

  const ContactNumbers<double>& n_;
  std::span<const RadialStep> known_;  // of a lap nearby
  PeriodicState& s_;
  LayerMotion<double> layer_;
  double scale_, tolerance_, gap_{0}, progress_{1};
};

// The guess of a slice that has just opened or closed may lead nowhere: then the search begins at rest.
PeriodicState searched(const ContactNumbers<double>& numbers, const LapGuess* guess,
                       std::span<const RadialStep> known, double accuracy) {
  PeriodicState state;
  RadialSearch(numbers, accuracy, known, state).run(guess);
  const bool done = state.status == PeriodicStatus::ok || guess == nullptr;
  return done ? state : searched(numbers, nullptr, {}, accuracy);
}

}  // namespace

PeriodicState find_radial_state(const ContactNumbers<double>& numbers, const LapGuess* guess,
                                double accuracy) {
  return searched(numbers, guess, {}, accuracy);
}

PeriodicState radial_state_beside(const ContactNumbers<double>& numbers,
                                  const PeriodicState& known) {
  const LapGuess guess(known.entry);
  return searched(numbers, &guess, known.steps, 0);
}

namespace {

// Means of a lap from rest, or from a state that moves as S says.
template <typename S>
ContactMeans<S> balanced_means(const ContactNumbers<S>& numbers, const LapEntry<S>& entry,
                               std::span<const RadialStep> steps) {
  ContactMeans<S> means = run_radial_lap(numbers, entry, {steps}).means;
  balance(numbers, means);
  return means;
}

// First derivatives in one lap, with directions for the state at entry, by the implicit function theorem.
template <int N>
ContactMeans<Dual<double, N>> means_along(const ContactNumbers<Dual<double, N>>& numbers,
                                          const PeriodicState& state) {
  constexpr int kState = static_cast<int>(kNumbers);
  using Wide = Dual<double, N + kState>;
  const auto direction = [](std::size_t i) { return N + static_cast<int>(i); };
  LapEntry<Wide> entry = moving_entry<Wide>(state.entry);
  entry.layer.e.d[N] = entry.layer.rate.d[N + 1] = entry.across.e.d[N + 2] =
      entry.across.rate.d[N + 3] = 1;
  const ContactNumbers<Wide> wide = widened<kState>(numbers);
  const Lap<Wide> lap = run_radial_lap(wide, entry, {state.steps});
  const auto next = listed(lap.next);
  Matrix m;
  for (std::size_t i = 0; i < kNumbers; ++i)
    for (std::size_t j = 0; j < kNumbers; ++j) m[i][j] = (i == j ? 1 : 0) - next[i].d[direction(j)];
  const Factors<kNumbers> slope(m);
  std::array<std::array<double, kNumbers>, N> motion;
  for (int i = 0; i < N; ++i)
    motion[i] = slope.solve(
        std::array<double, kNumbers>{next[0].d[i], next[1].d[i], next[2].d[i], next[3].d[i]});
  const auto along = [&](const Wide& x) {
    Dual<double, N> r(x.v);
    for (int i = 0; i < N; ++i) {
      r.d[i] = x.d[i];
      for (std::size_t j = 0; j < kNumbers; ++j) r.d[i] += x.d[direction(j)] * motion[i][j];
    }
    return r;
  };
  const ContactMeans<Wide>& w = lap.means;
  ContactMeans<Dual<double, N>> means{along(w.traction),       along(w.stator_power),
                                      along(w.friction_power), along(w.layer_loss),
                                      along(w.stick_length),   along(w.reactive_force)};
  balance(numbers, means);
  return means;
}

// Any derivatives: the periodic state in S by Newton's steps; its value is known, only derivatives come in.
template <typename S>
ContactMeans<S> means_of_moving_state(const ContactNumbers<S>& numbers,
                                      const PeriodicState& state) {
  LapEntry<S> entry = moving_entry<S>(state.entry);
  const Factors<kNumbers> slope = return_slope(values_of(numbers), state.entry, state.steps);
  for (int depth = 0; depth < kDualDepth<S>; ++depth) {
    const std::array<S, kNumbers> step =
        newton_step(slope, entry, run_radial_lap(numbers, entry, {state.steps}).next);
    std::array<S, kNumbers> to = listed(entry);
    for (std::size_t i = 0; i < kNumbers; ++i)
      to[i] = with_value(S(to[i] + step[i]), value_of(to[i]));
    move(entry, to);
  }
  return balanced_means(numbers, entry, state.steps);
}

}  // namespace

template <typename S>
ContactMeans<S> radial_means(const ContactNumbers<S>& numbers, const PeriodicState& state) {
  if constexpr (kDualDepth<S> == 0) {
    return state.lap.means;
  } else {
    if (!state.remembers) return balanced_means(numbers, moving_entry<S>(state.entry), state.steps);
    if constexpr (kDualDepth<S> == 1)
      return means_along(numbers, state);
    else
      return means_of_moving_state(numbers, state);
  }
}

#define TWUM_INSTANTIATE(S) \
  template ContactMeans<S> radial_means(const ContactNumbers<S>&, const PeriodicState&);
TWUM_FOR_EACH_CONTACT_SCALAR(TWUM_INSTANTIATE)
#undef TWUM_INSTANTIATE

}  // namespace twum::inline v0_1::contact
