// SPDX-License-Identifier: Apache-2.0
#include "contact/return_map.hpp"
#include "contact/periodic_state.hpp"
#include "contact/scalars.hpp"
#include "random_contact.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>
#include <set>
#include <vector>

using namespace twum;
using namespace twum::contact;
using namespace twum::test;

TEST_CASE("with mu_0 = mu no lap increases the energy of a difference of states (E6.1)",
          "[core][contact][identity]") {
  Dice dice(41);
  for (int i = 0; i < 1000; ++i) {
    const ContactNumbers<double> n = random_contact(dice, i);
    const LayerMotion<double> layer(n.inertia, n.damping);
    if (!layer.has_inertia()) continue;
    const LayerState<double> a{dice.uniform(-0.3, 0.3), dice.uniform(-1, 1)};
    const LayerState<double> b{dice.uniform(-0.3, 0.3), dice.uniform(-1, 1)};
    const LayerState<double> fa =
        run_lap<double>(n, layer, {a, false, ZoneState::stick}).next.layer;
    const LayerState<double> fb =
        run_lap<double>(n, layer, {b, false, ZoneState::stick}).next.layer;
    const double before = layer.energy({a.e - b.e, a.rate - b.rate});
    const double after = layer.energy({fa.e - fb.e, fa.rate - fb.rate});
    // Rounding of states of order one.
    CHECK(after <= before * (1 + 1e-12) + 1e-14);
  }
}

TEST_CASE("the periodic state repeats itself and Newton's steps (E6.2) keep it few laps away",
          "[core][contact][identity]") {
  Dice dice(42);
  int most = 0, sum = 0;
  for (int i = 0; i < 1000; ++i) {
    const ContactNumbers<double> n = random_contact(dice, i);
    const LayerMotion<double> layer(n.inertia, n.damping);
    const PeriodicState state = find_periodic_state(n, layer);
    REQUIRE(state.status == PeriodicStatus::ok);
    // Rounding of forces of order one, amplified by the response at resonance.
    CHECK(apart(layer, state.entry.layer, state.lap.next.layer) <=
          1e-12 * std::sqrt(1 + layer.response));
    most = std::max(most, state.laps);
    sum += state.laps;
  }
  // Damping ratios reach down to 1e-3: a layer of frequency beta then decays by 2 pi 1e-3 beta a lap, and
  // plain laps would need 37 / (2 pi 1e-3 beta), thousands for slow layers, to forget where they began.
  CHECK(sum <= 10 * 1000);
  CHECK(most <= 100);
}

TEST_CASE("secants (E6.4, E6.5) and Newton's steps lead where plain laps from rest lead",
          "[core][contact][differential]") {
  Dice dice(44);
  int compared = 0, sticking = 0, laps = 0, plain = 0;
  for (int i = 0; i < 3000; ++i) {
    const ContactNumbers<double> n = random_contact(dice, i, true);
    const LayerMotion<double> layer(n.inertia, n.damping);
    LapEntry<double> entry{{0, 0}, false, ZoneState::stick};
    Lap<double> lap;
    double gap = 1, before = 1;
    int k = 0;
    for (; k < 300 && gap > 1e-13; ++k) {
      lap = run_lap(n, layer, entry);
      REQUIRE(lap.status == LapStatus::ok);
      before = gap;
      gap = std::sqrt(
          layer.energy({lap.next.layer.e - entry.layer.e, lap.next.layer.rate - entry.layer.rate}));
      entry = lap.next;
    }
    if (gap > 1e-13) continue;
    ++compared;
    plain += k;
    sticking += lap.means.stick_length > 0;
    const PeriodicState state = find_periodic_state(n, layer);
    REQUIRE(state.status == PeriodicStatus::ok);
    laps += state.laps;
    // Laps that contract by r and end with a gap g are g r / (1 - r) away from the state that repeats itself,
    // up to a tenth; forces of order one, amplified by the response, bring rounding.
    const double rate = gap / before;
    const double bound = 1.1 * gap * rate / (1 - rate) + 1e-13 * std::sqrt(1 + layer.response);
    CHECK(std::fabs(state.entry.layer.e - entry.layer.e) <= bound);
    CHECK(std::fabs(state.lap.means.traction - lap.means.traction) <= bound);
  }
  CHECK(compared > 2000);
  CHECK(sticking > 500);
  CHECK(laps < plain);  // they are there to save some
}

TEST_CASE(
    "leaps past a state that has just ceased to be lead where plain laps lead, with mu_0 > mu",
    "[core][contact][differential]") {
  Dice dice(46);
  int slow = 0, saved = 0;
  const auto at = [](ContactNumbers<double> n, double speed) {
    n.speed_ratio = speed;
    return find_periodic_state(n, LayerMotion<double>(n.inertia, n.damping));
  };
  for (int i = 0; i < 1500; ++i) {
    const ContactNumbers<double> n = random_contact(dice, 2, true);
    // Closes in on a speed at which laps from rest begin to lead elsewhere.
    double low = dice.uniform(0.1, 0.6), high = low + 0.1;
    const auto traction = [&](double speed) {
      const PeriodicState state = at(n, speed);
      return state.status == PeriodicStatus::ok ? state.lap.means.traction : HUGE_VAL;
    };
    double at_low = traction(low), at_high = traction(high);
    for (int k = 0; k < 18 && at_low != at_high; ++k) {
      const double middle = 0.5 * (low + high), here = traction(middle);
      const bool is_low = std::fabs(here - at_low) < std::fabs(here - at_high) || here == at_low;
      (is_low ? low : high) = middle, (is_low ? at_low : at_high) = here;
    }
    if (!(std::fabs(at_high - at_low) > 1e-3)) continue;
    for (const double speed : {low, high}) {
      ContactNumbers<double> here = n;
      here.speed_ratio = speed;
      const LayerMotion<double> layer(n.inertia, n.damping);
      LapEntry<double> entry{{0, 0}, false, ZoneState::stick};
      double gap = 1;
      int laps = 0, alike = 0, longest = 0;
      Lap<double> lap;
      for (; laps < 1500 && gap > 1e-13; ++laps) {
        const std::uint64_t zones = lap.itinerary;
        lap = run_lap(here, layer, entry);
        alike = lap.itinerary == zones ? alike + 1 : 0, longest = std::max(longest, alike);
        gap = apart(layer, lap.next.layer, entry.layer);
        entry = lap.next;
      }
      if (gap > 1e-13 || longest < 150) continue;  // laps through many zones wander about
      ++slow;
      const PeriodicState state = at(n, speed);
      CAPTURE(i, speed, laps, state.laps);
      REQUIRE(state.status == PeriodicStatus::ok);
      // 4e-7 beside a fold laps contract by the root of that, a thousandth: a gap of 1e-13 leaves 1e-10.
      CHECK(std::fabs(state.lap.means.traction - lap.means.traction) < 1e-9);
      saved += laps - state.laps;
    }
  }
  CHECK(slow > 5);
  CHECK(saved > 100 * slow);  // of some 300
}

TEST_CASE("a lap that follows another (E6.5), or is proven beside it, is the lap that is marched",
          "[core][contact][differential]") {
  Dice dice(45);
  int followed = 0, refused = 0, wrong = 0;
  for (int i = 0; i < 3000; ++i) {
    const ContactNumbers<double> n = random_contact(dice, i, i % 2 == 0);
    const LayerMotion<double> layer(n.inertia, n.damping);
    const LapEntry<double> entry{{dice.uniform(-0.1, 0.1), dice.uniform(-0.3, 0.3)}};
    const double move = dice.log_uniform(1e-9, 1e-1);
    LapEntry<double> beside = entry;
    beside.layer.e += move * dice.uniform(-0.1, 0.1);
    beside.layer.rate += move * dice.uniform(-0.3, 0.3);
    const Lap<double> lap = run_lap(n, layer, entry), marched = run_lap(n, layer, beside);
    // States of order one; zones end to rounding over the slope of their f, which may be small.
    const double tolerance = 1e-11 * std::sqrt(1 + layer.response);
    const auto apart = [&](const LayerState<double>& a, const LayerState<double>& b) {
      return std::sqrt(layer.energy({a.e - b.e, a.rate - b.rate}));
    };

    const Lap<double> proven = prove_lap(n, layer, beside, lap.sequence);
    REQUIRE(proven.itinerary == marched.itinerary);
    CHECK(apart(proven.next.layer, marched.next.layer) <= tolerance);
    CHECK(std::fabs(proven.means.traction - marched.means.traction) <= tolerance);

    const Lap<double> found = follow_states(n, layer, beside, lap.sequence);
    if (found.status != LapStatus::ok) {
      ++refused;
      continue;
    }
    if (lap.itinerary != marched.itinerary) {
      ++wrong;  // an event that only a march sees: such a lap has to be proven
      continue;
    }
    ++followed;
    CHECK(found.sequence.count == marched.sequence.count);
    CHECK(apart(found.next.layer, marched.next.layer) <= tolerance);
  }
  CHECK(followed > 1500);
  CHECK(refused > 50);
  CHECK(wrong < 100);
}

TEST_CASE("laps that begin beside a periodic state stay beside it, with mu_0 > mu too (E6.6)",
          "[core][contact][limit]") {
  Dice dice(48);
  int answered = 0, refused = 0;
  for (int i = 0; i < 10000; ++i) {
    ContactNumbers<double> n = random_contact(dice, i, true);
    if (i % 3 == 0) n.damping = 0;
    const LayerMotion<double> layer(n.inertia, n.damping);
    const double turn = dice.uniform(0, 2 * std::numbers::pi);
    if (!layer.has_inertia() || layer.response > 1e4) continue;
    const PeriodicState state = find_periodic_state(n, layer);
    if (state.status != PeriodicStatus::ok) {
      ++refused;
      continue;
    }
    if (!state.remembers) continue;
    ++answered;
    CAPTURE(i, state.laps, n.half_angle, n.speed_ratio, n.threshold / n.kinetic);
    // Beside it by 1e-9 of a force of order one: rounding, amplified by the response, is far below, and so are
    // the curvature of the map and other sequences of zones, but for zones as short as this.
    LapEntry<double> entry = state.entry;
    const double away = 1e-9 * std::sqrt(1 + layer.response);
    entry.layer.e += away * std::cos(turn);
    entry.layer.rate += away * std::sin(turn) * layer.natural_frequency();
    Lap<double> lap;
    for (int k = 0; k < 100; ++k, entry = lap.next) lap = run_lap(n, layer, entry);
    const double gap = apart(layer, entry.layer, state.entry.layer);
    // A map that attracts may stretch before it shrinks; an eigenvalue above 1.05 would have carried it off
    // a hundred times as far in these 100 laps.
    CHECK(gap <= 100 * away);
  }
  CHECK(answered > 2000);
  CHECK(refused > 10);
}

TEST_CASE("what laps from rest never come to is no answer, with mu_0 > mu (E6.6)",
          "[core][contact][differential]") {
  Dice dice(51);
  int none = 0;
  for (int i = 0; i < 300; ++i) {
    ContactNumbers<double> n = random_contact(dice, 2, true);
    n.inertia = dice.log_uniform(2e-3, 8e-3);
    n.damping = 0;
    n.stick_rate = dice.uniform(0.1, 0.2);
    n.speed_ratio = dice.uniform(0.1, 0.4);
    n.threshold = 1.6 * n.kinetic;
    const LayerMotion<double> layer(n.inertia, 0.0);
    LapEntry<double> entry{{0, 0}, false, ZoneState::stick};
    double least = HUGE_VAL;
    for (int k = 0; k < 800; ++k) {
      const Lap<double> lap = run_lap(n, layer, entry);
      least = std::min(least, apart(layer, lap.next.layer, entry.layer));
      entry = lap.next;
    }
    // Laps that come to a state come to rounding of each other, and those that circle round one keep a share of
    // the way there from rest, 0.1 or so: only what stays above 1e-3 has come to nothing. What slips all through
    // is circled round as well.
    if (least < 1e-3) continue;
    const PeriodicState state = find_periodic_state(n, layer);
    if (state.status == PeriodicStatus::ok && state.lap.one_slip) continue;
    ++none;
    CAPTURE(i, n.inertia, n.half_angle, n.speed_ratio, n.stick_rate, n.kinetic, least);
    CHECK(state.status == PeriodicStatus::no_periodic_state);
  }
  CHECK(none > 20);
}

TEST_CASE(
    "a fixed point attracts if its eigenvalues lie inside the unit circle, or as a pair on it "
    "(E6.6)",
    "[core][contact][closed_form]") {
  Dice dice(50);
  int inside = 0, outside = 0;
  for (int i = 0; i < 2000; ++i) {
    const Matrix2 j{dice.uniform(-1.5, 1.5), dice.uniform(-1.5, 1.5), dice.uniform(-1.5, 1.5),
                    dice.uniform(-1.5, 1.5)};
    // Half the sum of the eigenvalues, and half their difference.
    const double middle = 0.5 * (j.a + j.d);
    const std::complex<double> half =
        std::sqrt(std::complex<double>(0.25 * (j.a - j.d) * (j.a - j.d) + j.b * j.c, 0));
    const double largest = std::max(std::abs(middle + half), std::abs(middle - half));
    if (j.a * j.d - j.b * j.c > 1 || std::fabs(largest - 1) < 1e-9)
      continue;  // no lap does that (E6.6)
    CHECK(attracts(j) == (largest < 1));
    ++(largest < 1 ? inside : outside);
  }
  CHECK(inside > 100);
  CHECK(outside > 100);
  for (const double turn : {0.1, 1.0, 3.0}) {
    CHECK(attracts({std::cos(turn), std::sin(turn), -std::sin(turn), std::cos(turn)}));
    CHECK(attracts({std::cos(turn), 2 * std::sin(turn), -0.5 * std::sin(turn), std::cos(turn)}));
  }
  CHECK_FALSE(attracts({1.1, 0, 0, 0.1}));
  CHECK_FALSE(attracts({-1.1, 0, 0, -0.1}));
}

TEST_CASE("laps through other zones have another itinerary", "[core][contact][identity]") {
  Dice dice(49);
  std::map<std::uint64_t, std::vector<ZoneState>> zones_of;
  std::set<std::vector<ZoneState>> sequences;
  for (int i = 0; i < 3000; ++i) {
    const ContactNumbers<double> n = random_contact(dice, i, true);
    const LayerMotion<double> layer(n.inertia, n.damping);
    core::Vector<ZoneTrace> trace;
    const LapEntry<double> entry{{dice.uniform(-0.1, 0.1), dice.uniform(-0.3, 0.3)}};
    const Lap<double> lap = run_lap<double>(n, layer, entry, nullptr, &trace);
    std::vector<ZoneState> zones;
    for (const ZoneTrace& z : trace) zones.push_back(z.zone.state);
    CHECK(zones_of.emplace(lap.itinerary, zones).first->second == zones);
    sequences.insert(zones);
  }
  CHECK(sequences.size() > 10);
}

TEST_CASE("no lap increases areas of the plane of states (E6.6)", "[core][contact][identity]") {
  Dice dice(46);
  int reversing = 0;
  for (int i = 0; i < 3000; ++i) {
    const ContactNumbers<double> v = random_contact(dice, i, i % 2 == 0);
    const LayerMotion<double> layer(v.inertia, v.damping);
    if (!layer.has_inertia()) continue;
    LapEntry<StateDual> entry{
        {StateDual(dice.uniform(-0.1, 0.1)), StateDual(dice.uniform(-0.3, 0.3))},
        false,
        ZoneState::stick};
    entry.layer.e.d[0] = 1;
    entry.layer.rate.d[1] = 1;
    const ContactNumbers<StateDual> n{
        v.inertia,     v.damping,    v.stick_rate,
        v.speed_ratio, v.half_angle, v.peak,
        v.kinetic,     v.threshold,  {v.edge.sin, v.edge.cos, v.edge.versine},
        v.full};
    const Lap<StateDual> lap =
        run_lap<StateDual>(n, LayerMotion<StateDual>(n.inertia, n.damping), entry);
    REQUIRE(lap.status == LapStatus::ok);
    const LayerState<StateDual> next = lap.next.layer;
    const double det = next.e.d[0] * next.rate.d[1] - next.e.d[1] * next.rate.d[0];
    reversing += lap.zones > 1 && lap.means.stick_length.v == 0;
    // Each entry of F' is of order one in the energy norm; where slip nearly turns into stick a reversal
    // divides rounding by a small v_rel'.
    CHECK(std::fabs(det) <= std::exp(-2 * std::numbers::pi * v.damping / v.inertia) + 1e-10);
  }
  CHECK(reversing > 50);
}

TEST_CASE("an undamped layer slips as one of vanishing damping does, with mu_0 > mu too (E6.6)",
          "[core][contact][limit]") {
  Dice dice(47);
  int slipping = 0;
  for (int i = 0; i < 3000 && slipping < 200; ++i) {
    ContactNumbers<double> n = random_contact(dice, i, true);
    if (!(n.inertia > 0) || n.full) continue;
    n.damping = 0;
    const LayerMotion<double> layer(n.inertia, 0.0);
    if (layer.response > 1e4) continue;
    // Where laps from rest stick now and then they may end in a cycle of several.
    LapEntry<double> entry{{0, 0}, false, ZoneState::stick};
    int slips = 0;
    for (; slips < 100; ++slips) {
      const Lap<double> lap = run_lap(n, layer, entry);
      if (lap.zones > 1 || lap.first == ZoneState::stick) break;
      entry = lap.next;
    }
    if (slips < 100) continue;
    ++slipping;
    CAPTURE(i, n.inertia, n.half_angle, n.speed_ratio);
    const PeriodicState state = find_periodic_state(n, layer);
    REQUIRE(state.status == PeriodicStatus::ok);
    // The error of a little damping is linear in it: twice the damping, twice the difference, but for the
    // share of it that is lost from entry to entry, 2 pi 5e-9, over the distance from a resonance of laps.
    double difference[2];
    for (const int times : {1, 2}) {
      n.damping = 1e-8 * times * n.inertia;
      const PeriodicState damped =
          find_periodic_state(n, LayerMotion<double>(n.inertia, n.damping));
      REQUIRE(damped.status == PeriodicStatus::ok);
      difference[times - 1] = damped.entry.layer.e - state.entry.layer.e;
    }
    CHECK(std::fabs(difference[1] - 2 * difference[0]) <=
          1e-3 * std::fabs(difference[0]) + 1e-12 * std::sqrt(1 + layer.response));
  }
  CHECK(slipping == 200);
}

TEST_CASE("a layer that sticks all round drifts by 2 pi s V a lap (E6.3)",
          "[core][contact][closed_form]") {
  ContactNumbers<double> n{0.01, 0.05, 0.2, 1e-4, std::numbers::pi, 9, 0.3, 0.3, {0, -1, 2}, true};
  const LayerMotion<double> layer(n.inertia, n.damping);
  const LapEntry<double> entry{{0, n.stick_rate * (-1 - n.speed_ratio)}, true, ZoneState::stick};
  const Lap<double> lap = run_lap(n, layer, entry);
  REQUIRE(lap.zones == 1);
  CHECK(std::fabs(lap.next.layer.e + 2 * std::numbers::pi * n.stick_rate * n.speed_ratio) < 1e-15);
}

TEST_CASE("strain and traction while sticking are those of (T5.2, T5.3, E2.3)",
          "[core][contact][quadrature]") {
  // A lap that sticks all round: the mean traction is that of M e'' + C e' + e with
  // e' = s (cos theta - V), integrated by hand: e'' and the cosine of e' have no mean.
  ContactNumbers<double> n{0.3, 0.4, 0.2, 1e-3, std::numbers::pi, 9, 0.3, 0.3, {0, -1, 2}, true};
  const LayerMotion<double> layer(n.inertia, n.damping);
  const double e0 = 0.1, s = n.stick_rate, V = n.speed_ratio;
  const Lap<double> lap =
      run_lap(n, layer, LapEntry<double>{{e0, s * (-1 - V)}, true, ZoneState::stick});
  REQUIRE(lap.zones == 1);
  // e = e0 + s sin theta - s V (theta + pi): its mean is e0 - s V pi.
  CHECK(std::fabs(lap.means.traction - (e0 - s * V * std::numbers::pi - n.damping * s * V)) <
        1e-15);
  CHECK(std::fabs(lap.means.layer_loss - n.damping * s * (0.5 + V * V)) < 1e-15);
}

TEST_CASE("slip responds to the wave as (T5.1, E1.2) says, with v_rel of (T2.4)",
          "[core][contact][identity]") {
  Dice dice(43);
  for (int i = 0; i < 200; ++i) {
    const ContactNumbers<double> n = random_contact(dice, i);
    const LayerMotion<double> layer(n.inertia, n.damping);
    const double sigma = i % 2 ? 1 : -1, theta = dice.uniform(-1, 1) * n.half_angle;
    const Harmonic<double> f = forced_response(n, layer, sigma);
    const Trig<double> a = trig(theta);
    const double p = n.peak - a.versine;
    const double residual = n.inertia * f.curvature(a) + n.damping * f.slope(a) + f.at(theta, a) +
                            sigma * n.kinetic * p;
    CHECK(std::fabs(residual) <= 1e-14 * (1 + layer.response) * (1 + n.inertia + n.damping));
    // (E1.3) times s, the layer's own motion left out
    CHECK(std::fabs(relative_rate(n, f).at(theta, a) -
                    (f.slope(a) - n.stick_rate * (std::cos(theta) - n.speed_ratio))) <=
          1e-14 * (1 + layer.response + n.stick_rate));
  }
}
