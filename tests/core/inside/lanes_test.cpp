// SPDX-License-Identifier: Apache-2.0
#include "contact/lanes.hpp"
#include "contact/lane_laps.hpp"
#include "contact/lane_runner.hpp"
#include "random_contact.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

using namespace twum;
using namespace twum::contact;
using namespace twum::test;

namespace {

using Pairs = Lanes<LaneWidth::baseline>;

double in_lane(const Pairs& x, int lane) { return x.v[lane]; }

// Two different numbers.
template <typename Number>
Pairs lanes_of(Number number) {
  const double numbers[] = {number(), number()};
  return Pairs(numbers);
}

// One contact after the other, as on a processor without vectors.
void run_lanes_single(const LayerMotion<double>& layer, LaneBatch& batch) {
  for (int lane = 0; lane < kLanes; ++lane) LaneRunner<LaneWidth::single>(layer, batch, lane).run();
}

// A layer with inertia and a quick decay, underdamped and overdamped in turn, in a contact of any kind.
ContactNumbers<double> quiet_contact(Dice& dice, int index) {
  ContactNumbers<double> n = random_contact(dice, 2);
  n.inertia = dice.log_uniform(1e-5, 2e-2);
  const double ratio = index % 2 == 0 ? dice.uniform(0.1, 0.9) : dice.uniform(1.6, 6);
  n.damping = 2 * ratio * std::sqrt(n.inertia);
  return n;
}

// Contacts that one layer enters at rest: they differ as the slices of a track do.
struct Track {
  LayerMotion<double> layer;
  std::vector<ContactNumbers<double>> contacts;

  Track(Dice& dice, int index) : Track(quiet_contact(dice, index), dice) {}

  Track(const ContactNumbers<double>& n, Dice& dice) : layer(n.inertia, n.damping) {
    const double faster = dice.log_uniform(1e-3, 0.3), wider = dice.log_uniform(1e-3, 0.3);
    for (int k = 0; k < kLanes; ++k) {
      ContactNumbers<double> slice = n;
      const double place = (k - 3.5) / 4;
      slice.speed_ratio *= 1 + faster * place;
      set_half_angle(slice, std::min(3.1, n.half_angle * (1 + wider * place)));
      if (goes_in_step(slice, layer)) contacts.push_back(slice);
    }
  }
};

struct InStep {
  std::vector<Lap<double>> laps;
  std::vector<LaneLap> lanes;

  explicit InStep(const Track& track, LaneCode& code = *lane_codes().back())
      : laps(track.contacts.size()) {
    for (std::size_t k = 0; k < laps.size(); ++k) lanes.push_back({&track.contacts[k], &laps[k]});
    run_in_step(track.layer, lanes, code);
  }
};

Lap<double> alone(const Track& track, std::size_t k) {
  return run_lap(track.contacts[k], track.layer, LapEntry<double>{{0, 0}});
}

// In units of the largest traction; powers of the fastest speed as well.
double apart(const ContactNumbers<double>& n, const ContactMeans<double>& a,
             const ContactMeans<double>& b) {
  const double force = n.threshold * n.peak, power = force * (1 + std::fabs(n.speed_ratio));
  return std::max({std::fabs(a.traction - b.traction) / force,
                   std::fabs(a.reactive_force - b.reactive_force) / force,
                   std::fabs(a.stator_power - b.stator_power) / power,
                   std::fabs(a.friction_power - b.friction_power) / power,
                   std::fabs(a.layer_loss - b.layer_loss) / power});
}

}  // namespace

TEST_CASE("elementary functions in lanes", "[core][lanes]") {
  Dice dice(11);
  for (int i = 0; i < 20'000; ++i) {
    const Pairs below = lanes_of([&] { return -dice.log_uniform(1e-9, 700); });
    const Pairs angle = lanes_of([&] { return dice.uniform(-1, 1) * dice.log_uniform(1e-3, 1e5); });
    const Pairs x = lanes_of([&] { return dice.uniform(-1, 1); });
    const Pairs y = lanes_of([&] { return dice.uniform(-1, 1); });
    const Pairs power = exp(below), root = sqrt(fabs(x));
    const SinCos<Pairs> at = sincos(angle);
    for (int lane = 0; lane < 2; ++lane) {
      // Two roundings of the even and the odd part, and one of their sum, which is above 0.7 of either.
      CHECK(in_lane(power, lane) ==
            Approx(std::exp(in_lane(below, lane))).epsilon(6e-16).margin(0));
      // A rounding of the reduced angle, two of numbers up to 1 and half a one of the library.
      CHECK(std::fabs(in_lane(at.sin, lane) - std::sin(in_lane(angle, lane))) <= 4e-16);
      CHECK(std::fabs(in_lane(at.cos, lane) - std::cos(in_lane(angle, lane))) <= 4e-16);
      CHECK(in_lane(root, lane) == std::sqrt(std::fabs(in_lane(x, lane))));
      const double less =
          std::atan2(in_lane(y, lane), in_lane(x, lane)) - in_lane(least_argument(x, y), lane);
      CHECK((less >= 0 && less <= 2e-4));
    }
  }
  CHECK(in_lane(exp(Pairs(-1e300)), 0) < 1e-300);
  CHECK(in_lane(select(Pairs(1.0) < Pairs(2.0), 3.0, 4.0), 1) == 3);
}

TEST_CASE("a lap in step with others is the lap alone", "[core][lanes]") {
  Dice dice(12);
  long found = 0, asked = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Track track(dice, i);
    const InStep step(track);
    for (std::size_t k = 0; k < track.contacts.size(); ++k) {
      ++asked;
      if (!step.lanes[k].found) continue;
      ++found;
      const Lap<double>&lap = step.laps[k], reference = alone(track, k);
      REQUIRE(reference.status == LapStatus::ok);
      REQUIRE(lap.itinerary == reference.itinerary);
      REQUIRE(lap.zones == reference.zones);
      CHECK(lap.one_slip == reference.one_slip);
      CHECK(lap.first == reference.first);
      // Both round what is_delicate() lets through, up to 1e-13.
      CHECK(apart(track.contacts[k], lap.means, reference.means) <= 2e-13);
      // The places of ends are known up to rounding over the slope of what ends the zone.
      CHECK(std::fabs(lap.means.stick_length - reference.means.stick_length) <= 1e-11);
      CHECK(std::fabs(lap.shortest - reference.shortest) <= 1e-11);
    }
  }
  // Few have so many zones, or come so close to an end, that they go alone.
  CHECK(asked > 5'000);
  CHECK(100 * found > 98 * asked);
}

TEST_CASE("a zone that just appears is not missed in step", "[core][lanes][events]") {
  Dice dice(13);
  int edges = 0;
  for (int i = 0; i < 3'000; ++i) {
    Track track(dice, i);
    if (track.contacts.empty()) continue;
    // Between two speeds with different zones there is one where they change.
    ContactNumbers<double> n = track.contacts[0];
    const auto zones_at = [&](double V) {
      n.speed_ratio = V;
      return run_lap(n, track.layer, LapEntry<double>{{0, 0}}).itinerary;
    };
    double low = dice.uniform(0, 1.5), high = dice.uniform(0, 1.5);
    const std::uint64_t zones = zones_at(low);
    if (zones == zones_at(high)) continue;
    for (int halving = 0; halving < 60; ++halving) {
      const double middle = 0.5 * (low + high);
      (zones_at(middle) == zones ? low : high) = middle;
    }
    ++edges;
    track.contacts.assign(kLanes, n);
    for (int k = 0; k < kLanes; ++k)
      track.contacts[static_cast<std::size_t>(k)].speed_ratio =
          low + (k % 2 == 0 ? 1 : -1) * std::pow(10.0, -12 + k);
    const InStep step(track);
    for (std::size_t k = 0; k < kLanes; ++k) {
      if (!step.lanes[k].found) continue;
      const Lap<double> reference = alone(track, k);
      // Closer to the edge rounding decides, and then the zone is as short as the root of that: its part in the means, its
      // length times what the traction differs by, is of the order of the distance.
      if (k >= 2) CHECK(step.laps[k].itinerary == reference.itinerary);
      CHECK(apart(track.contacts[k], step.laps[k].means, reference.means) <= 1e-11);
    }
  }
  CHECK(edges > 100);
}

TEST_CASE("a contact alone and vectors of every width give the same bytes", "[core][lanes]") {
  Dice dice(14);
  for (int i = 0; i < 2'000; ++i) {
    const Track track(dice, i);
    const InStep single(track, run_lanes_single);
    for (LaneCode* code : lane_codes()) {
      const InStep wide(track, *code);
      for (std::size_t k = 0; k < track.contacts.size(); ++k) {
        REQUIRE(wide.lanes[k].found == single.lanes[k].found);
        const Lap<double>&a = single.laps[k], &b = wide.laps[k];
        REQUIRE(std::memcmp(&a.means, &b.means, sizeof a.means) == 0);
        REQUIRE(std::memcmp(&a.exit, &b.exit, sizeof a.exit) == 0);
        REQUIRE(a.itinerary == b.itinerary);
        for (int z = 0; z < a.zones; ++z)
          REQUIRE(a.sequence.ends[z].length == b.sequence.ends[z].length);
      }
    }
  }
}

TEST_CASE("contacts that a layer does not enter at rest go alone", "[core][lanes]") {
  Dice dice(15);
  ContactNumbers<double> n = random_contact(dice, 2);
  n.stick_rate = 1, n.inertia = 0.01;
  set_half_angle(n, 1);
  const auto goes = [&n](double damping) {
    n.damping = damping;
    return goes_in_step(n, LayerMotion<double>(n.inertia, n.damping));
  };
  CHECK_FALSE(goes(20));    // decays by a twentieth a radian
  CHECK_FALSE(goes(0.2));   // critical damping
  CHECK_FALSE(goes(0.16));  // by 8 a radian, over 4.28 radians: exp(-34) is left
  CHECK(goes(0.18));
  const double inertia = n.inertia;
  n.inertia =
      1e-11;  // its vibration turns by 316 000 rad per radian of the wave, more than the sine of lanes takes
  CHECK_FALSE(goes(1e-6));
  n.inertia = 1e-8;
  CHECK(goes(1e-5));
  n.inertia = inertia, n.damping = 0.18;
  n.threshold = 1.1 * n.kinetic;
  CHECK_FALSE(goes_in_step(n, LayerMotion<double>(n.inertia, n.damping)));
  CHECK_FALSE(goes_in_step(n, LayerMotion<double>(0, 0)));
}
