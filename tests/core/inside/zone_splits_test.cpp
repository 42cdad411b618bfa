// SPDX-License-Identifier: Apache-2.0
#include "model/zone_splits.hpp"
#include "metrics/motor_parts.hpp"
#include "model/track.hpp"
#include "support/test_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

using namespace twum;
using namespace twum::core;

namespace {

// How long the zone is that begins at a distance from a break.
using Law = double (*)(double distance);

double root(double distance) { return 0.3 * std::sqrt(distance); }
double line(double distance) { return 0.2 * distance; }
double jump(double /*distance*/) { return 0.4; }

// A track on which zones change at some places, in parts of it.
struct MadeTrack final : SliceQueries {
  const DrivenMotor<double>& motor;
  std::vector<double> breaks;
  Law law;
  int gap{-1};  // number of breaks below the places without an answer
  mutable int calls{0};

  MadeTrack(const DrivenMotor<double>& its_motor, std::vector<double> places, Law of_length)
      : motor(its_motor), breaks(std::move(places)), law(of_length) {}

  SliceZones zones(double radius) const override {
    ++calls;
    return at_place(place_of(radius));
  }
  // Nothing helps to find them.
  std::optional<contact::Jump> jump(double /*low*/, double /*high*/) const override { return {}; }
  double margin(double radius, const contact::Jump& /*jump*/) const override {
    return place_of(radius) - breaks.front();
  }

  SliceZones at_place(double place) const {
    const auto next = std::upper_bound(breaks.begin(), breaks.end(), place);
    const auto index = next - breaks.begin();
    if (index == gap) return {SliceZones::kNoAnswer, HUGE_VAL};
    const double length = index == 0 ? 1 : law(place - next[-1]);
    return {static_cast<std::uint64_t>(100 + index), length};
  }
  double place_of(double radius) const {
    const Piece<double>& piece = motor.pieces.front();
    return (radius - piece.low) / (piece.high - piece.low);
  }
  Vector<SliceZones> zones_of(std::span<const Slice<double>> slices) const {
    Vector<SliceZones> zones;
    for (const Slice<double>& s : slices) zones.push_back(at_place(place_of(s.radius)));
    return zones;
  }
  Vector<Split> splits() { return zone_splits(motor, zones_of(motor.annulus), *this); }
  std::vector<double> found() {
    std::vector<double> places;
    for (const Split& split : splits()) places.push_back(split.place);
    return places;
  }
};

Motor motor_of_eight(double threshold) {
  MotorDesign design = test::ring_motor();
  design.stator.radial_slices = -8;
  design.friction.threshold = threshold * design.friction.kinetic;
  return Motor(design);
}

const DrivenMotor<double>& track_of_eight() {
  static const Motor motor = motor_of_eight(1);
  return MotorParts::model(motor);
}

// mu_0 > mu
const DrivenMotor<double>& jumping_track() {
  static const Motor motor = motor_of_eight(1.3);
  return MotorParts::model(motor);
}

}  // namespace

TEST_CASE("the track is split where zones begin, whatever the law of their length (W4.4)",
          "[core][annulus][made]") {
  for (const Law law : {&root, &line, &jump}) {
    for (const std::vector<double>& breaks :
         {std::vector{0.001}, {0.37}, {0.999}, {0.2, 0.6}, {0.41, 0.47, 0.55}}) {
      MadeTrack track{track_of_eight(), breaks, law};
      const std::vector<double> places = track.found();
      CAPTURE(breaks, places, track.calls);
      REQUIRE(places.size() == breaks.size());
      for (std::size_t i = 0; i < breaks.size(); ++i) {
        const double distance = std::abs(places[i] - breaks[i]);
        // Secants over lines and over squares of roots are exact, unless the bracket of 1e-6 ends the search.
        CHECK(distance <= 1e-6);
      }
      CHECK(track.calls <= 2 + 30 * static_cast<int>(breaks.size()));
    }
  }
}

TEST_CASE("a track is split where its slices jump, however near one another (W4.5)",
          "[core][annulus][made]") {
  for (const std::vector<double>& breaks :
       {std::vector{0.001}, {0.37}, {0.2, 0.6}, {0.5, 0.5003}, {0.41, 0.411, 0.55}}) {
    MadeTrack track{jumping_track(), breaks, &jump};
    const std::vector<double> places = track.found();
    CAPTURE(breaks, places, track.calls);
    REQUIRE(places.size() == breaks.size());
    for (std::size_t i = 0; i < breaks.size(); ++i)
      CHECK(std::abs(places[i] - breaks[i]) <= 1e-10);  // halved to that
  }
}

TEST_CASE("with mu_0 > mu zones that begin from nothing are found by their length (W4.4, W4.5)",
          "[core][annulus][made]") {
  for (const Law law : {&root, &line}) {
    for (const std::vector<double>& breaks : {std::vector{0.001}, {0.37}, {0.2, 0.6}}) {
      MadeTrack track{jumping_track(), breaks, law};
      const std::vector<double> places = track.found();
      CAPTURE(breaks, places, track.calls);
      REQUIRE(places.size() == breaks.size());
      for (std::size_t i = 0; i < breaks.size(); ++i)
        CHECK(std::abs(places[i] - breaks[i]) <= 1e-6);
      // Halving to 1e-10 takes 30 for each.
      CHECK(track.calls <= 2 + 15 * static_cast<int>(breaks.size()));
    }
  }
}

// A jump whose margin is straight, at another place in each point, and a zone between the nodes that no split tells.
TEST_CASE(
    "splits of a point nearby are followed to their jumps, and unseen changes are seen (W4.5)",
    "[core][annulus][made]") {
  const DrivenMotor<double>& motor = jumping_track();
  MadeTrack track{motor, {0.4}, &jump};
  const contact::Jump known{contact::Jump::Kind::in_slip, 0, 0, 1, 0};
  const auto found = followed_splits(motor, {{{0, 0.38}, known}}, track);
  REQUIRE(found.has_value());
  REQUIRE(found->size() == 1);
  CHECK(std::abs(found->front().place - 0.4) <= 1e-13);

  const Vector<Slice<double>> slices = annulus_of<double>(motor, fixed_places(*found));
  CHECK(change_at_splits(motor, *found, slices, track.zones_of(slices), track));
  for (const double unseen : {0.1, 0.395, 0.405, 0.999}) {
    track.breaks = {std::min(unseen, 0.4), std::max(unseen, 0.4)};
    CAPTURE(unseen);
    CHECK(!change_at_splits(motor, *found, slices, track.zones_of(slices), track));
  }
  track.breaks = {};  // a jump that is gone
  CHECK(!change_at_splits(motor, *found, slices, track.zones_of(slices), track));
  // A state that only one side has would have to be followed too, and a jump far away may be another one.
  contact::Jump of_state = known;
  of_state.beside = -1;
  CHECK(!followed_splits(motor, {{{0, 0.38}, of_state}}, track));
  track.breaks = {0.9};
  CHECK(!followed_splits(motor, {{{0, 0.38}, known}}, track));
  track.breaks = {1.01};  // beyond the track
  CHECK(!followed_splits(motor, {{{0, 0.95}, known}}, track));
}

TEST_CASE("slices without an answer between two others are passed over where they are few (W4.5)",
          "[core][annulus][made]") {
  for (const double width : {1e-5, 1e-3, 0.05}) {
    const double low = 0.5, high = low + width;
    MadeTrack track{jumping_track(), {low, high}, &jump};
    track.gap = 1;  // between the two breaks
    const Vector<Split> splits = track.splits();
    CAPTURE(width, splits.size());
    if (width >
        0.005) {  // too many: they are a panel of their own, which says that it has no answer
      CHECK(splits.size() == 2);
      continue;
    }
    REQUIRE(splits.size() == 1);
    CHECK(std::abs(splits[0].place - low) <= 1e-6);
    CHECK(splits[0].gap >= width);
    CHECK(splits[0].gap <= 2 * (width + 1e-6));  // found by steps that double
  }
}

TEST_CASE("a track without a change of zones is not split (W4.4)", "[core][annulus][made]") {
  MadeTrack track{track_of_eight(), {}, &root};
  CHECK(track.found().empty());
  CHECK(track.calls == 2);  // at the edges
}

TEST_CASE("zones that come and go within half a percent of a piece are one split (W4.4)",
          "[core][annulus][made]") {
  MadeTrack track{track_of_eight(), {0.5, 0.503}, &root};
  const std::vector<double> places = track.found();
  REQUIRE(places.size() == 1);
  CHECK(places.front() == Approx(0.5015).margin(0.002));
}

// One slice just past the end of its plateau: the speed moves past the break as the radius does along a track. The laws hold
// up to the root of the relative distance to the break, 2e-3, times numbers of order one.
TEST_CASE("a zone of stick opens like a root, and takes its square from the torque (W4.4)",
          "[core][annulus][scaling]") {
  const Motor motor(test::ring_motor());
  const double end = evaluate(motor, {Metric::plateau_speed}).value;
  const double plateau = motor.operating_point(0.5 * end).torque;
  const OperatingPoint near = motor.operating_point(end * (1 + 1e-6)),
                       far = motor.operating_point(end * (1 + 4e-6));
  CHECK(far.stick_fraction / near.stick_fraction == Approx(2).epsilon(0.01));
  CHECK((plateau - far.torque) / (plateau - near.torque) == Approx(4).epsilon(0.01));
}
