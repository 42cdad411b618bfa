// SPDX-License-Identifier: Apache-2.0
#include "support/deviations.hpp"
#include "support/test_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>

#include <string>

// The regimes of the paper's figure 3 (theory section 6) and the trends of its figures 4 to 6.
namespace {

using namespace twum;
using namespace twum::test;

std::string sequence(const Motor& motor, double speed) {
  std::string text;
  for (const Zone& zone : motor.zones(speed)) {
    if (!text.empty()) text += " ";
    text += to_string(zone.state);
  }
  return text;
}

// NaN, which no comparison accepts, if the metric has no value.
double metric(const MotorDesign& design, Metric which) {
  return evaluate(Motor(design), MetricRequest{which}).value;
}

}  // namespace

TEST_CASE("a 60 mm motor passes the four regimes of the paper", "[core][contact][published]") {
  const MotorDesign design = GENERATE(ring_motor(), damped(ring_motor()));
  const Motor motor(design);
  const double free = metric(design, Metric::no_load_speed);
  Deviation regimes("the four regimes of figure 3", 0);
  CHECK(regimes.add(sequence(motor, 0) == "slip+", true, 1) == 0);
  CHECK(regimes.add(sequence(motor, 0.85 * free) == "slip+ stick slip+", true, 1) == 0);
  const std::string third = sequence(motor, 0.97 * free);
  CAPTURE(third);
  const bool third_found = third == "slip- stick slip+" || third == "slip- stick slip-" ||
                           third == "slip+ stick slip+" || third == "stick slip+" ||
                           third == "stick slip-";
  CHECK(regimes.add(third_found, true, 1) == 0);
  const std::string beyond = sequence(motor, 1.05 * free);
  CAPTURE(beyond);
  const bool braking = beyond == "slip- stick slip-" || beyond == "stick slip-";
  CHECK(regimes.add(braking, true, 1) == 0);
  CHECK(regimes.add(sequence(motor, 1.4 * free) == "slip-", true, 1) == 0);
}

TEST_CASE("a wide contact of a stiff layer has the paper's five zones",
          "[core][contact][published]") {
  // Rigid limit: v_rel changes sign at cos theta = U / V0 on either side of the crest; a stiff layer
  // sticks for a short while at both. Contact reaches past both, as theta_L = 2.2.
  MotorDesign design = ring_motor();
  design.layer.given_shear_modulus = 60e9;
  design = at_load(design, 0.7);
  const Motor motor(design);
  Deviation zones_agree("the five zones of a wide, stiff contact", 0);
  const bool five = sequence(motor, 0.5 * motor.crest_speed()) == "slip- stick slip+ stick slip-";
  CHECK(zones_agree.add(five, true, 1) == 0);
  const auto zones = motor.zones(0.5 * motor.crest_speed());
  // |theta*| = 60 degrees; sticking begins at or after it and is as short as S is small
  REQUIRE(zones.size() == 5);
  CHECK(zones[1].from == Approx(-1.0472).margin(0.2));
  CHECK(zones[3].from == Approx(1.0472).margin(0.2));
}

TEST_CASE("amplitude does not change the torque of a contact that slips one way",
          "[core][point][published]") {
  // While all slips the torque is mu F_N r whatever A; exact but for rounding of the half angle.
  MotorDesign design = ring_motor();
  const double coulomb = 0.2 * 160 * 0.0265;
  Deviation stall("stall torque at three amplitudes, of mu F_N r", 1e-12);
  for (const double amplitude : {1.2e-6, 1.6e-6, 2.4e-6}) {
    design.stator.amplitude = amplitude;
    CHECK(sequence(Motor(design), 0) == "slip+");
    CHECK(stall.add(metric(design, Metric::stall_torque), coulomb, coulomb) <= 1e-12);
  }
}

TEST_CASE("more amplitude means a higher no-load speed", "[core][point][published]") {
  MotorDesign low = ring_motor();
  MotorDesign high = ring_motor();
  low.stator.amplitude = 1.2e-6;
  high.stator.amplitude = 2.4e-6;
  Deviation trend("no-load speed rises with amplitude", 0);
  CHECK(trend.add(metric(high, Metric::no_load_speed) > metric(low, Metric::no_load_speed), true,
                  1) == 0);
}

TEST_CASE("more preload widens the contact and lowers the no-load speed",
          "[core][point][published]") {
  const MotorDesign base = GENERATE(ring_motor(), damped(ring_motor()), elastic(ring_motor()));
  Deviation trend("preload widens the contact and lowers the no-load speed", 0);
  double ratio = 0;
  double speed = 1e300;
  for (const double preload : {20.0, 60.0, 160.0, 400.0, 800.0}) {
    MotorDesign design = base;
    design.preload = preload;
    CHECK(trend.add(metric(design, Metric::contact_ratio) > ratio, true, 1) == 0);
    CHECK(trend.add(metric(design, Metric::no_load_speed) < speed, true, 1) == 0);
    ratio = metric(design, Metric::contact_ratio);
    speed = metric(design, Metric::no_load_speed);
  }
}

TEST_CASE("a thinner layer raises the no-load speed", "[core][point][published]") {
  const MotorDesign base = GENERATE(damped(ring_motor()), elastic(ring_motor()));
  Deviation trend("a thinner layer raises the no-load speed", 0);
  double speed = 0;
  for (const double thickness : {0.8e-3, 0.4e-3, 0.2e-3, 0.1e-3}) {
    MotorDesign design = base;
    design.layer.thickness = thickness;
    CHECK(trend.add(metric(design, Metric::no_load_speed) > speed, true, 1) == 0);
    speed = metric(design, Metric::no_load_speed);
  }
}

TEST_CASE("sticking begins at the leading edge when an elastic layer creeps",
          "[core][contact][published]") {
  // Carter's picture of rolling contact: little creep leaves the leading edge stuck, slip trails.
  const Motor motor(at_load(elastic(ring_motor()), 1e-3));
  const double free = metric(motor.design(), Metric::no_load_speed);
  const auto zones = motor.zones(free * (1 - 2e-4));
  REQUIRE(zones.size() >= 2);
  Deviation carter("stick at the leading edge, slip at the trailing one", 0);
  CHECK(carter.add(zones.front().state != ZoneState::slip_plus, true, 1) == 0);
  CHECK(carter.add(zones.back().state == ZoneState::slip_plus, true, 1) == 0);
}
