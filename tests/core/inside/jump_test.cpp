// SPDX-License-Identifier: Apache-2.0
#include "contact/jump.hpp"
#include "contact/periodic_state.hpp"
#include "random_contact.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdint>

using namespace twum;
using namespace twum::contact;
using namespace twum::test;

namespace {

PeriodicState state_of(const ContactNumbers<double>& n) {
  return find_periodic_state(n, {n.inertia, n.damping});
}

ContactNumbers<double> at_ratio(ContactNumbers<double> n, double ratio) {
  n.speed_ratio = ratio;
  return n;
}

}  // namespace

// Halving over the speed finds the place where the sequence of zones changes, from whole laps alone. The margin has to change its
// sign there, and may not exceed its slope times the interval that is left (1e-10). Only layers that come back at rest are asked:
// then one lap decides. Tests of derivatives cover the others.
TEST_CASE("the margin of a jump vanishes where the zones change (W4.5)", "[core][inside][oracle]") {
  Dice dice(20261126);
  int jumps = 0;
  for (int index = 0; index < 20'000; ++index) {
    const ContactNumbers<double> n = random_contact(dice, index, true);
    if (!enters_at_rest(n, LayerMotion<double>(n.inertia, n.damping))) continue;
    double low = dice.uniform(0, 1), high = low + 0.02;
    const PeriodicState first = state_of(at_ratio(n, low)), last = state_of(at_ratio(n, high));
    if (first.status != PeriodicStatus::ok || last.status != PeriodicStatus::ok ||
        first.lap.itinerary == last.lap.itinerary)
      continue;
    while (high - low > 1e-10) {
      const double middle = 0.5 * (low + high);
      const PeriodicState state = state_of(at_ratio(n, middle));
      const bool like_first =
          state.status == PeriodicStatus::ok && state.lap.itinerary == first.lap.itinerary;
      (like_first ? low : high) = middle;
    }
    const ContactNumbers<double> below = at_ratio(n, low), above = at_ratio(n, high);
    const double step =
        std::fabs(state_of(above).lap.means.traction - state_of(below).lap.means.traction);
    if (!(step > 1e-5 * n.threshold)) continue;  // a zone that begins from nothing
    const auto jump = jump_between(below, above);
    CAPTURE(index, low, step);
    REQUIRE(jump.has_value());
    const double at_low = jump_margin(below, *jump), at_high = jump_margin(above, *jump);
    CAPTURE(static_cast<int>(jump->kind), jump->turn, jump->zone, at_low, at_high);
    CHECK(at_low * at_high <= 0);
    const double slope = (jump_margin(at_ratio(n, high + 1e-6), *jump) - at_high) / 1e-6;
    CHECK(std::fabs(at_low) <= 1.1e-10 * std::fabs(slope) + 1e-14);
    ++jumps;
  }
  CHECK(jumps >= 50);
}
