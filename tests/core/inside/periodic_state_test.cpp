// SPDX-License-Identifier: Apache-2.0
#include "contact/periodic_state.hpp"
#include "contact/radial_state.hpp"
#include "random_contact.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

using namespace twum;
using namespace twum::contact;
using namespace twum::test;

namespace {

constexpr double kPi = std::numbers::pi;

// Contacts of every kind: four in ten of them full and a tenth narrow, a tenth without damping, a quarter of them near
// rest and some of these backward.
ContactNumbers<double> any_contact(Dice& dice, int index, bool threshold) {
  ContactNumbers<double> n = random_contact(dice, index, threshold);
  const double extent = dice.uniform(0, 1), ringing = dice.uniform(0, 1), pace = dice.uniform(0, 1);
  const double slow = dice.log_uniform(1e-6, 1), narrow = dice.log_uniform(0.02, 1);
  const double load = dice.log_uniform(1.02, 12);
  if (extent < 0.4) {
    set_full_contact(n, load);
  } else if (extent < 0.5) {
    set_half_angle(n, narrow);
  }
  if (ringing < 0.1) n.damping = 0;
  if (pace < 0.25) n.speed_ratio = pace < 0.05 ? -slow : slow;
  return n;
}

// Largest e and t that friction can bring about: the sizes that rounding goes with.
double size_of(const ContactNumbers<double>& n, const LayerMotion<double>& layer) {
  return n.threshold * n.peak * (1 + std::sqrt(layer.response));
}

// M e'' + C e' + e = 0 by its characteristic roots, in complex numbers.
LayerState<double> left_alone(const ContactNumbers<double>& n, const LayerState<double>& from,
                              double x) {
  if (n.inertia == 0) {
    const double e = from.e * std::exp(-x / n.damping);
    return {e, -e / n.damping};
  }
  using Complex = std::complex<double>;
  const Complex half = std::sqrt(Complex(n.damping * n.damping - 4 * n.inertia, 0));
  const Complex fast = (-n.damping - half) / (2 * n.inertia), slow = 1.0 / (n.inertia * fast);
  const Complex u = (from.rate - slow * from.e) / (fast - slow) * std::exp(fast * x);
  const Complex w = (from.rate - fast * from.e) / (slow - fast) * std::exp(slow * x);
  return {(u + w).real(), (fast * u + slow * w).real()};
}

}  // namespace

TEST_CASE("a layer enters with what its free flight left of the state it left with (E1.2)",
          "[core][contact][closed_form]") {
  Dice dice(52);
  int kept = 0, forgotten = 0;
  for (int i = 0; i < 1500; ++i) {
    // Nearly full contact, so that the flight takes a radian at most, and less than 0.1 in many.
    ContactNumbers<double> n = random_contact(dice, i, i % 2 == 0);
    set_half_angle(n, kPi - dice.log_uniform(0.01, 0.5));
    n.stick_rate = dice.log_uniform(0.02, 50);
    if (n.damping == 0) continue;
    const LayerMotion<double> layer(n.inertia, n.damping);
    const Lap<double> lap = run_lap<double>(n, layer, {{0, 0}, false, ZoneState::stick});
    REQUIRE(lap.status == LapStatus::ok);
    const LayerState<double> expected = left_alone(n, lap.exit, 2 * (kPi - n.half_angle));
    LayerState<double> exit = lap.exit;
    if (n.inertia == 0) exit.rate = -exit.e / n.damping;
    const double size = std::sqrt(layer.energy(exit));
    CAPTURE(i, n.inertia, n.damping, n.half_angle, size);
    // Near critical damping both ways subtract modes that are nearly alike, which costs the ratio of a rate to the
    // difference of the two, some hundred in the nearest of these layers: 1e-14 of the state, and as much again for
    // phases of some hundred radians.
    CHECK(apart(layer, lap.next.layer, expected) <= 1e-12 * size);
    const double left = std::sqrt(layer.energy(expected));
    kept += left > 1e-3 * size;
    forgotten += left < 1e-15 * size;
  }
  CHECK(kept > 300);
  CHECK(forgotten > 50);
}

TEST_CASE("with mu_0 = mu every contact in motion has its periodic state, and energy in balance",
          "[core][contact][identity]") {
  Dice dice(53);
  int full = 0, undamped = 0, slow = 0;
  for (int i = 0; i < 3000; ++i) {
    const ContactNumbers<double> n = any_contact(dice, i, false);
    const LayerMotion<double> layer(n.inertia, n.damping);
    const PeriodicState state = find_periodic_state(n, layer);
    CAPTURE(i, n.full, n.inertia, n.damping, n.speed_ratio, state.laps);
    // There is one, and what laps come to is section 6 of the theory; it counts without damping too.
    REQUIRE(state.status == PeriodicStatus::ok);
    full += n.full, undamped += n.damping == 0, slow += std::fabs(n.speed_ratio) < 1e-3;
    // Rounding of some thousand operations on states of this size.
    const Lap<double> again = run_lap(n, layer, state.entry);
    CHECK(apart(layer, again.next.layer, state.entry.layer) <= 1e-12 * size_of(n, layer));
    // (T7.10) in the contact's own units, to the same rounding.
    const ContactMeans<double>& m = state.lap.means;
    const double taken = n.speed_ratio * m.traction + m.friction_power + m.layer_loss;
    CHECK(std::fabs(m.stator_power - taken) <=
          1e-12 * size_of(n, layer) * std::max(1.0, std::fabs(n.speed_ratio)));
  }
  CHECK(full > 1000);
  CHECK(undamped > 300);
  CHECK(slow > 200);
}

TEST_CASE(
    "contact that would stick all round at rest slips in each turn of a rotor that moves (E6.3)",
    "[core][contact][limit]") {
  Dice dice(59);
  int forward = 0, backward = 0, sticking = 0;
  for (int i = 0; i < 3000; ++i) {
    ContactNumbers<double> n = random_contact(dice, i);
    set_full_contact(n, dice.log_uniform(1.02, 12));
    // Loss factors up to 2, the range of section 10.
    n.damping = i % 7 == 0 ? 0 : dice.log_uniform(1e-3, 2);
    // What a layer that follows the stator swings by, as a share of mu_0 times the mean pressure.
    const double share = dice.log_uniform(0.03, 1.5), mean = n.threshold * (n.peak - 1);
    n.stick_rate = share * mean / (n.damping + std::fabs(1 - n.inertia));
    n.speed_ratio = dice.log_uniform(1e-6, 0.3) * (dice.uniform(0, 1) < 0.5 ? -1 : 1);
    // Its traction is a constant and s (D sin theta + C cos theta), to stay within mu_0 (cos theta + mean).
    const double swing = (1 - n.inertia) * n.stick_rate, pull = n.damping * n.stick_rate;
    const double least = std::hypot(n.threshold + pull, swing) - mean;
    const double most = mean - std::hypot(n.threshold - pull, swing);
    if (least > most) continue;
    const LayerMotion<double> layer(n.inertia, n.damping);
    const PeriodicState state = find_periodic_state(n, layer);
    CAPTURE(i, n.inertia, n.damping, n.speed_ratio, state.laps);
    // Section 6 of the theory: with mu_0 = mu it is there, and laps come to it.
    CHECK(state.status == PeriodicStatus::ok);
    // A layer that stuck all round would be carried off by the rotor, turn by turn.
    CHECK((state.lap.zones > 1 || state.lap.one_slip));
    sticking += state.lap.zones > 1;
    ++(n.speed_ratio > 0 ? forward : backward);
  }
  CHECK(forward > 1000);
  CHECK(backward > 1000);
  CHECK(sticking > 2000);
}

TEST_CASE("where a search gives up, laps do not settle, also where a cycle of laps begins",
          "[core][contact][brute_force]") {
  Dice dice(61);
  int cycles = 0;
  const auto settles = [&](ContactNumbers<double> n, double speed) {
    n.speed_ratio = speed;
    const LayerMotion<double> layer(n.inertia, n.damping);
    const PeriodicState state = find_periodic_state(n, layer);
    if (state.status == PeriodicStatus::ok) return true;
    CAPTURE(n.inertia, n.damping, n.half_angle, n.threshold / n.kinetic, speed, state.laps);
    REQUIRE(state.status == PeriodicStatus::no_periodic_state);
    LapEntry<double> entry{{0, 0}, false, ZoneState::stick};
    double closest = size_of(n, layer);
    for (int i = 0; i < 1500; ++i) {
      const LapEntry<double> next = run_lap(n, layer, entry).next;
      if (i >= 1400) closest = std::min(closest, apart(layer, next.layer, entry.layer));
      entry = next;
    }
    // Laps that settle come as near as rounding lets them, some 1e-16 of the size.
    CHECK(closest > 1e-14 * size_of(n, layer));
    ++cycles;
    return false;
  };
  for (int i = 0; i < 400; ++i) {
    ContactNumbers<double> n = random_contact(dice, 2, true);
    n.damping = 2 * std::sqrt(n.inertia) * dice.log_uniform(1e-3, 0.1);
    double low = dice.uniform(0.3, 0.8), high = dice.uniform(0.8, 1.2);
    const bool at_low = settles(n, low);
    if (settles(n, high) == at_low) continue;
    for (int k = 0; k < 25; ++k) {
      const double middle = 0.5 * (low + high);
      (settles(n, middle) == at_low ? low : high) = middle;
    }
  }
  CHECK(cycles > 100);
}

TEST_CASE("full contact leaves a lap in the zone that it entered in, and no zone has no length",
          "[core][contact][identity]") {
  Dice dice(54);
  int full = 0, partial = 0, changing = 0;
  for (int i = 0; i < 3000; ++i) {
    const ContactNumbers<double> n = any_contact(dice, i, i % 4 == 0);
    const LayerMotion<double> layer(n.inertia, n.damping);
    const PeriodicState state = find_periodic_state(n, layer);
    if (state.status != PeriodicStatus::ok) continue;
    CAPTURE(i, n.full, n.inertia, n.damping, n.speed_ratio);
    // Zones of random contacts are tenths of a radian long as a rule: only one in some thousands of such draws
    // would hold one as short as this by chance.
    CHECK(state.lap.shortest > 1e-9);
    ++(n.full ? full : partial);
    if (!n.full) continue;
    CHECK(state.entry.carried);
    CHECK(state.entry.zone == state.lap.next.zone);
    CHECK(state.lap.first == state.entry.zone);
    changing += state.lap.zones > 1;
  }
  CHECK(full > 800);
  CHECK(partial > 1000);
  CHECK(changing > 300);
}

TEST_CASE("friction and stick rate scaled alike scale the state and its means (E1.2, E1.3)",
          "[core][contact][scaling]") {
  Dice dice(55);
  int scaled = 0, without = 0;
  for (int i = 0; i < 1000; ++i) {
    const ContactNumbers<double> n = any_contact(dice, i, i % 3 == 0);
    const LayerMotion<double> layer(n.inertia, n.damping);
    const PeriodicState state = find_periodic_state(n, layer);
    const double factor = i % 2 == 0 ? 0x1p-20 : 0x1p20;
    ContactNumbers<double> k = n;
    k.kinetic *= factor, k.threshold *= factor, k.stick_rate *= factor;
    const PeriodicState scaled_state = find_periodic_state(k, layer);
    CAPTURE(i, factor, n.full, n.inertia, n.damping, n.speed_ratio, state.laps, scaled_state.laps);
    REQUIRE(scaled_state.status == state.status);
    if (state.status != PeriodicStatus::ok) {
      ++without;
      continue;
    }
    ++scaled;
    // The equations are linear in e, t, mu, mu_0 and s, and powers of two bring no rounding. Only the lap at
    // which a search ends may differ, by what its laps still close in: 1e-12 of the size in each of a thousand.
    const double bound = 1e-9 * size_of(n, layer) * std::max(1.0, std::fabs(n.speed_ratio));
    const ContactMeans<double>&a = state.lap.means, &b = scaled_state.lap.means;
    CHECK(std::fabs(scaled_state.lap.exit.e / factor - state.lap.exit.e) <= bound);
    CHECK(std::fabs(b.traction / factor - a.traction) <= bound);
    CHECK(std::fabs(b.stator_power / factor - a.stator_power) <= bound);
    CHECK(std::fabs(b.friction_power / factor - a.friction_power) <= bound);
    CHECK(std::fabs(b.layer_loss / factor - a.layer_loss) <= bound);
  }
  CHECK(scaled > 800);
  CHECK(without > 20);
}

TEST_CASE(
    "where the periodic state need not be unique the search begins at rest whatever the guess",
    "[core][contact][identity]") {
  Dice dice(56);
  int undamped = 0, threshold = 0, full = 0;
  for (int i = 0; i < 800; ++i) {
    const ContactNumbers<double> n = any_contact(dice, i, i % 4 == 0);
    const LayerMotion<double> layer(n.inertia, n.damping);
    const LapGuess guess(LapEntry<double>{{dice.uniform(-0.3, 0.3), dice.uniform(-1, 1)}});
    const bool unique = n.damping > 0 && n.threshold == n.kinetic && !n.full;
    if (unique) continue;
    (n.full ? full : n.threshold > n.kinetic ? threshold : undamped) += 1;
    const PeriodicState from_rest = find_periodic_state(n, layer);
    const PeriodicState guessed = find_periodic_state(n, layer, &guess);
    CAPTURE(i, n.full, n.inertia, n.damping);
    // The same search: the same bits.
    CHECK(guessed.status == from_rest.status);
    CHECK(guessed.laps == from_rest.laps);
    CHECK(guessed.entry.layer.e == from_rest.entry.layer.e);
    CHECK(guessed.entry.layer.rate == from_rest.entry.layer.rate);
  }
  CHECK(undamped > 50);
  CHECK(threshold > 50);
  CHECK(full > 200);
}

TEST_CASE("a state of full contact with some accuracy is as near to the exact one",
          "[core][contact][limit]") {
  Dice dice(58);
  int found = 0, shorter = 0;
  for (int i = 0; found < 400; ++i) {
    ContactNumbers<double> n = any_contact(dice, i, true);
    n.threshold = n.kinetic;
    if (!n.full || !(n.damping > 0)) continue;
    const LayerMotion<double> layer(n.inertia, n.damping);
    const PeriodicState exact = find_periodic_state(n, layer);
    const double accuracy = dice.log_uniform(1e-9, 1e-4);
    const PeriodicState near = find_periodic_state(n, layer, nullptr, accuracy);
    CAPTURE(i, accuracy, exact.laps, near.laps);
    REQUIRE(near.status == exact.status);
    if (exact.status != PeriodicStatus::ok) continue;
    ++found;
    shorter += near.laps < exact.laps;
    CHECK(near.laps <= exact.laps);
    // The last lap left a tenth of the gap at most, so all further ones add up to less than the gap that was left.
    CHECK(distance(layer, near.lap.next.layer, exact.lap.next.layer) <=
          accuracy * size_of(n, layer) + 1e-12 * size_of(n, layer));
  }
  CHECK(shorter > 100);
}

TEST_CASE("a search has cost all the zones that it went through", "[core][contact][identity]") {
  Dice dice(57);
  int at_once = 0, later = 0;
  for (int i = 0; i < 1000; ++i) {
    const ContactNumbers<double> n = any_contact(dice, i, i % 2 == 0);
    const LayerMotion<double> layer(n.inertia, n.damping);
    const PeriodicState state = find_periodic_state(n, layer);
    CAPTURE(i, state.laps);
    REQUIRE(state.laps >= 1);
    REQUIRE(state.lap.zones >= 1);
    // The last lap is gone through in full, so it counts; where it is the only one, it is all.
    CHECK(state.zones >= state.lap.zones);
    if (state.laps == 1) CHECK(state.zones == state.lap.zones);
    ++(state.laps == 1 ? at_once : later);
  }
  CHECK(at_once > 50);
  CHECK(later > 500);
}

TEST_CASE("no state that plain laps of an undamped layer come to is refused, with mu_0 > mu",
          "[core][contact][differential]") {
  Dice dice(58);
  int refused = 0;
  for (int i = 0; i < 300; ++i) {
    ContactNumbers<double> n = random_contact(dice, 2, true);
    n.inertia = dice.log_uniform(0.5, 4);
    n.damping = 0;
    const LayerMotion<double> layer(n.inertia, 0.0);
    if (find_periodic_state(n, layer).status == PeriodicStatus::ok) continue;
    ++refused;
    LapEntry<double> entry{{0, 0}, false, ZoneState::stick};
    double gap = 1;
    for (int k = 0; k < 400 && gap > 1e-13; ++k) {
      const Lap<double> lap = run_lap(n, layer, entry);
      gap = apart(layer, lap.next.layer, entry.layer);
      entry = lap.next;
    }
    CAPTURE(i, n.inertia, n.half_angle, n.speed_ratio);
    // Laps that come to a state come to rounding of each other.
    CHECK(gap > 1e-13);
  }
  CHECK(refused > 3);
}

TEST_CASE(
    "as fast as the stator at the edge, a relaxed layer sticks if friction grows faster (E1.2)",
    "[core][contact][closed_form]") {
  // The wave runs on from v_rel = 0: in stick e' = s (cos theta - V) grows from zero with slope s sin(theta_L), and with
  // it traction C e' + e at first by C s sin(theta_L); the threshold mu p grows by mu sin(theta_L).
  Dice dice(71);
  int sticks = 0, slips = 0;
  for (int i = 0; i < 400; ++i) {
    ContactNumbers<double> n = random_contact(dice, 1);  // without inertia, with damping
    REQUIRE(n.inertia == 0);
    set_half_angle(n, dice.uniform(1.1, 3.0));
    n.speed_ratio =
        1 - n.edge.versine;  // exact for versines of 1/2 to 2, so that v_rel is zero to the bit
    n.stick_rate = n.kinetic / n.damping * dice.log_uniform(0.1, 10);
    const double ratio = n.damping * n.stick_rate / n.kinetic;
    if (std::fabs(ratio - 1) < 1e-6) continue;
    const LayerMotion<double> layer(n.inertia, n.damping);
    const Lap<double> lap = run_lap<double>(n, layer, {{0, 0}, false, ZoneState::stick});
    CAPTURE(i, ratio, n.half_angle);
    REQUIRE(lap.status == LapStatus::ok);
    // Where it is left behind the stator overtakes it.
    CHECK(lap.first == (ratio < 1 ? ZoneState::stick : ZoneState::slip_plus));
    (ratio < 1 ? sticks : slips) += 1;
  }
  CHECK(sticks > 50);
  CHECK(slips > 50);
}

// Beside speeds at which the sequence of zones changes, where most could go wrong: one of two laps may have a short zone more, where
// slip dips below zero by less than steps resolve. Each lap may be off by 1e-6 of the threshold. Layers that ring hundreds of
// times in the contact are left out.
TEST_CASE("a lap in the plane that follows one beside it goes where a lap by itself goes",
          "[core][contact][radial]") {
  Dice dice(77);
  int changes = 0, followed = 0;
  for (int i = 0; i < 150; ++i) {
    ContactNumbers<double> n = random_contact(dice, i);
    n.radial = dice.uniform(0.1, 0.8);
    n.threshold = n.kinetic;
    if (n.inertia < 1e-3) continue;
    const LayerMotion<double> layer(n.inertia, n.damping);
    const auto at = [&](double speed) {
      ContactNumbers<double> there = n;
      there.speed_ratio = speed;
      return find_periodic_state(there, layer);
    };
    const auto check_beside = [&](const PeriodicState& known, const PeriodicState& wanted,
                                  double speed) {
      if (known.steps.empty()) return;
      ContactNumbers<double> there = n;
      there.speed_ratio = speed;
      const PeriodicState found = radial_state_beside(there, known);
      INFO("contact " << i << " at " << speed << ", zones " << known.lap.zones << ", "
                      << wanted.lap.zones);
      CHECK(found.status == PeriodicStatus::ok);
      CHECK(std::abs(found.lap.means.traction - wanted.lap.means.traction) <
            2e-6 * n.threshold * n.peak);
      ++followed;
    };
    PeriodicState before = at(0.02);
    double low = 0.02;
    for (double high = 0.06; high < 1.2; high += 0.04) {
      PeriodicState after = at(high);
      if (before.status == PeriodicStatus::ok && after.status == PeriodicStatus::ok) {
        PeriodicState left = before, right = after;
        double from = low, to = high;
        while (left.lap.itinerary != right.lap.itinerary && to - from > 1e-9) {
          const double middle = 0.5 * (from + to);
          const PeriodicState between = at(middle);
          if (between.status != PeriodicStatus::ok) break;
          const bool same = between.lap.itinerary == left.lap.itinerary;
          (same ? left : right) = between, (same ? from : to) = middle;
        }
        if (left.lap.itinerary != right.lap.itinerary && to - from <= 1e-9) {
          ++changes;
          check_beside(left, right, to);
          check_beside(right, left, from);
        }
      }
      before = std::move(after), low = high;
    }
  }
  CHECK(changes > 50);
  CHECK(followed > 100);
}

// A stick zone is born where the slip velocity, above zero at every point of a step, dips below it between two of them. Its length then
// grows with the root of the speed (the dip is a parabola), so that its square is linear: a tenth for the next order.
TEST_CASE("a lap in the plane sees slip that dips below zero between the points of a step",
          "[core][contact][radial]") {
  Dice dice(77);
  ContactNumbers<double> n = random_contact(dice, 0);
  for (int i = 1; i <= 149; ++i) dice.uniform(0.1, 0.8), n = random_contact(dice, i);
  n.radial = dice.uniform(0.1, 0.8);
  n.threshold = n.kinetic;
  const LayerMotion<double> layer(n.inertia, n.damping);
  const auto square = [&](double speed) {
    n.speed_ratio = speed;
    const PeriodicState state = find_periodic_state(n, layer);
    REQUIRE(state.lap.zones == 3);
    return state.lap.shortest * state.lap.shortest;
  };
  const double low = square(0.08780), middle = square(0.08784), high = square(0.08788);
  CHECK((high - middle) / (middle - low) == Approx(1).epsilon(0.1));
}

// Where an elastic layer sticks all through without a torque, V = sin(theta_L) / theta_L (E2.3), the slip before the exit has no length.
TEST_CASE("a lap in the plane that sticks to the exit ends there", "[core][contact][radial]") {
  for (const double half : {0.3, 0.6, 0.90382251324233887}) {
    const double sine = std::sin(half), versine = 1 - std::cos(half);
    ContactNumbers<double> n{0,
                             0,
                             0.36893684617091749,
                             sine / half,
                             half,
                             versine,
                             0.23,
                             0.23,
                             {sine, 1 - versine, versine},
                             false,
                             0.44444444444444448};
    const PeriodicState state = find_periodic_state(n, LayerMotion<double>(0, 0));
    CHECK(state.status == PeriodicStatus::ok);
    CHECK(std::abs(state.lap.means.traction) < 1e-9 * n.threshold * n.peak);
  }
}
