// SPDX-License-Identifier: Apache-2.0
#include "core/curve_motors.hpp"
#include "core/scanned_motors.hpp"
#include "support/deviations.hpp"
#include "support/point_checks.hpp"
#include "support/test_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/base/error.hpp>
#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>
#include <twum/core/parameters.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

// Metrics where the characteristic jumps, ends, has a plateau, or is locked (theory section 7).
using namespace twum;
using namespace twum::test;

TEST_CASE("the speed at the torque of the plateau is where the plateau ends (T7.15, T7.17)",
          "[core][metrics][identity]") {
  int plateaus = 0;
  for (const Motor& motor : motors(8, 40, false)) {
    const double torque = ask(motor, Metric::stall_torque).value;
    const double end = ask(motor, Metric::plateau_speed).value;
    const double top = ask(motor, Metric::max_torque).value;
    if (!(end > 0) || top > torque * (1 + 1e-12)) continue;
    ++plateaus;
    const MetricValue found =
        evaluate(motor, MetricRequest{Metric::speed_at, Argument::torque, torque});
    REQUIRE(found.status == MetricStatus::ok);
    CHECK(found.value == end);
  }
  CHECK(plateaus > 5);
}

TEST_CASE("efficiencies have no value exactly where no power is put in (T7.6, T7.7)",
          "[core][metrics][identity]") {
  int braking = 0, helped = 0;
  for (Motor motor : motors(9, 12, true)) {
    MotorDesign design = motor.design();
    design.stator.modal_damping = 20;
    motor = Motor(design);
    for (int i = -2; i <= 15; ++i) {
      const double speed = 0.1 * i * motor.crest_speed();
      const OperatingPoint point = motor.operating_point(speed);
      if (point.status != PointStatus::ok) continue;
      CAPTURE(i, point.stator_power, point.stator_loss);
      const double velocity =
          2 * std::numbers::pi * design.stator.frequency * design.stator.amplitude;
      CHECK(point.stator_loss == Approx(20 * velocity * velocity).epsilon(1e-14));
      const auto status = [&](Metric which) { return at_speed(motor, which, speed).status; };
      const bool contact = point.stator_power > 0;
      const bool whole = point.stator_power + point.stator_loss > 0;
      CHECK((status(Metric::contact_efficiency_at) == MetricStatus::ok) == contact);
      CHECK((status(Metric::efficiency_at) == MetricStatus::ok) == whole);
      CHECK(std::isnan(point.contact_efficiency()) == !contact);
      CHECK(std::isnan(point.efficiency()) == !whole);
      for (const Metric which : {Metric::torque_at, Metric::output_power_at, Metric::layer_loss_at})
        CHECK(status(which) == MetricStatus::ok);
      braking += !contact;
      helped += whole && !contact;
    }
  }
  CHECK(braking > 20);
  CHECK(helped > 5);
}

TEST_CASE("a motor that is locked at rest has a no-load speed and a peak that stay at zero",
          "[core][metrics][limit]") {
  MotorDesign design = ring_motor();
  design.layer.given_shear_modulus = 1e7;
  design.layer.given_inertia = 0;
  design.preload = 8 * full_contact_load(design);
  const Motor motor(design);
  REQUIRE(motor.locks_at_rest());
  for (const auto& [which, smoothness] :
       {std::pair{Metric::no_load_speed, Smoothness::one_sided},
        std::pair{Metric::speed_at_peak_power, Smoothness::flat}}) {
    const MetricDerivative at_rest = differentiated(motor, MetricRequest{which});
    CHECK(at_rest.value.value == 0);
    CHECK(at_rest.smoothness == smoothness);
    for (const double each : at_rest.gradient) CHECK(each == 0);
  }
  // A request that names no speed is about rest.
  CHECK(evaluate(motor, MetricRequest{Metric::torque_at}).value == motor.operating_point(0).torque);
}

TEST_CASE("a peak of power where the torque jumps up moves with the plateau's end (T7.16, T7.17)",
          "[core][metrics][identity]") {
  Uniform random(52);
  int found = 0;
  for (int i = 0; i < 60; ++i) {
    MotorDesign design = realistic_design(random);
    design.friction.threshold = design.friction.kinetic * random(1.2, 2.5);
    const Motor motor(design);
    const double end = ask(motor, Metric::plateau_speed).value;
    const double best = ask(motor, Metric::speed_at_peak_power).value;
    if (!(end > 0) || std::abs(best - end) > 1e-9 * end) continue;
    const MetricDerivative of_end = differentiated(motor, MetricRequest{Metric::plateau_speed}),
                           of_best =
                               differentiated(motor, MetricRequest{Metric::speed_at_peak_power});
    if (of_end.smoothness == Smoothness::undefined) continue;
    ++found;
    CHECK(of_best.smoothness == Smoothness::one_sided);
    for (std::size_t j = 0; j < kParameterCount; ++j)
      CHECK(of_best.gradient[j] == of_end.gradient[j]);
  }
  CHECK(found > 3);
}

TEST_CASE("a motor without a plateau has none for its neighbours either (T7.17)",
          "[core][metrics][limit]") {
  // Contact beyond 90 degrees, where the crests' neighbours move backwards even at rest.
  MotorDesign design = ring_motor();
  design.layer.given_shear_modulus = 60e9;
  design.preload = 0.7 * full_contact_load(design);
  const Motor motor(design);
  REQUIRE(ask(motor, Metric::plateau_speed).value == 0);
  const MetricDerivative plateau = differentiated(motor, MetricRequest{Metric::plateau_speed});
  CHECK(plateau.smoothness == Smoothness::flat);
  for (const double each : plateau.gradient) CHECK(each == 0);
}

// With mu_0 > mu torque may jump: a maximum is the limit on its side of a jump.
TEST_CASE(
    "speeds and maxima are those of a fine scan, with mu_0 > mu too (T7.13, T7.14, T7.15, T7.16)",
    "[core][metrics][brute_force]") {
  Uniform random(51);
  int smooth = 0;
  for (int i = 0; i < 60; ++i) {
    MotorDesign design = i % 2 == 0 ? realistic_design(random) : random_box_point(random).design;
    design.friction.threshold = design.friction.kinetic * (i % 4 == 3 ? 1 : random(1.05, 2.5));
    if (i % 3 == 1) design = damped(design);
    const Motor motor(design);
    if (motor.contact().full || !(ask(motor, Metric::stall_torque).value > 0)) continue;
    const double unit = motor.holding_torque(), free = ask(motor, Metric::no_load_speed).value;
    constexpr int kPlaces = 2000;
    std::vector<double> torques;
    bool answered = std::isfinite(free);
    for (int k = 1; k <= kPlaces && answered; ++k) {
      const OperatingPoint point = motor.operating_point(1.1 * free * k / kPlaces);
      answered = point.status == PointStatus::ok;
      torques.push_back(point.torque);
    }
    if (!answered) continue;
    const auto speed_of = [&](int k) { return 1.1 * free * (k + 1) / kPlaces; };
    const auto torque_at = [&](double speed) { return motor.operating_point(speed).torque; };
    CAPTURE(i, free);
    for (const double load : {0.0, 0.01 * unit, 0.1 * unit, 0.3 * unit}) {
      const MetricValue found = ask_at_torque(motor, Metric::speed_at, load);
      CAPTURE(load, found.value);
      if (*std::max_element(torques.begin(), torques.end()) < load) continue;
      REQUIRE(found.status == MetricStatus::ok);
      for (int k = 0; k < kPlaces; ++k)
        if (speed_of(k) > found.value * (1 + 1e-12))
          CHECK(torques[static_cast<std::size_t>(k)] <= load + 1e-9 * unit);
      const auto fall = [&](double share) {
        const double before = torque_at(found.value * (1 - share)),
                     after = torque_at(found.value * (1 + share));
        // Whatever its slope, torque is on either side of the load there, but for the root's own error.
        CHECK(before >= load - 1e-9 * unit);
        CHECK(after <= load + 1e-9 * unit);
        return before - after;
      };
      const double kept = fall(1e-11) / fall(1e-9);  // of a slope a hundredth, of a jump all
      if (kept < 0.02) CHECK(std::abs(torque_at(found.value) - load) <= 1e-9 * unit);
      const bool undefined =
          differentiated(motor, {Metric::speed_at, Argument::torque, load}).smoothness ==
          Smoothness::undefined;
      if (kept < 0.02) CHECK_FALSE(undefined);
      if (kept > 0.5) CHECK(undefined);
      smooth += kept < 0.02;
    }
    const MetricValue top = ask(motor, Metric::max_torque), peak = ask(motor, Metric::peak_power);
    REQUIRE(top.status == MetricStatus::ok);
    REQUIRE(peak.status == MetricStatus::ok);
    const double best = ask(motor, Metric::speed_at_peak_power).value;
    for (int k = 0; k < kPlaces; ++k) {
      const double torque = torques[static_cast<std::size_t>(k)];
      CHECK(torque <= top.value * (1 + 1e-12));
      CHECK(torque * speed_of(k) <= peak.value * (1 + 1e-12));
    }
    // Nothing is better nearby, and as good only there: beside a jump power moves like a square root at the most,
    // and the root of 1e-12 is a hundredth of what is allowed.
    double nearby = 0;
    for (int k = -500; k <= 500; ++k) {
      const double speed = best * (1 + 1e-6 * k);
      CHECK(torque_at(speed) * speed <= peak.value * (1 + 1e-9));
    }
    for (const double side : {-1e-12, 0.0, 1e-12})
      nearby = std::max(nearby, torque_at(best * (1 + side)) * best);
    CHECK(nearby >= peak.value * (1 - 1e-4));
  }
  CHECK(smooth > 30);
}

TEST_CASE("efficiency has a maximum only if the stator loses power (T7.18)",
          "[core][metrics][limit]") {
  const MetricValue none = ask(Motor(ring_motor()), Metric::max_efficiency);
  CHECK(none.status == MetricStatus::undefined);
  CHECK(std::isnan(none.value));
  MotorDesign design = ring_motor();
  design.stator.modal_damping = 45;
  const Motor motor(design);
  const double best = ask(motor, Metric::max_efficiency).value;
  const double speed = ask(motor, Metric::speed_at_max_efficiency).value;
  CHECK(motor.operating_point(speed).efficiency() == Approx(best).epsilon(1e-10));
  double seen = 0;
  for (const OperatingPoint& point : scan(motor, 3000).points)
    seen = std::max(seen, point.efficiency());
  CHECK(best >= seen * (1 - 1e-12));
  CHECK(best <= seen * (1 + 1e-5));
}

TEST_CASE(
    "the plateau of a layer that still rings at the next entry ends where its slip does (T7.17)",
    "[core][metrics][differential]") {
  int plateaus = 0;
  Deviation slopes("derivative of the plateau's end of a ringing layer, relative", 1e-6);
  for (int i = 0; i < 30; ++i) {
    MotorDesign design = ring_motor();
    design.layer.loss_factor = 0.002 * (1 + i % 5);
    design.layer.given_inertia = 1e-4 * (1 + i);
    const Motor motor(design);
    const double end = ask(motor, Metric::plateau_speed).value;
    if (!(end > 0)) continue;
    ++plateaus;
    CAPTURE(i, end / motor.crest_speed());
    CHECK(motor.zones(end * (1 - 1e-7)).size() == 1);
    CHECK(motor.zones(end * (1 + 1e-7)).size() > 1);
    // The end's derivative in the preload, by its values at a distance of 1e-4: the error of the difference is
    // 1e-8 of a third derivative, which may be some tens.
    const auto end_at = [&](double preload) {
      return ask(Motor(with(design, Parameter::preload, preload)), Metric::plateau_speed).value;
    };
    const double load = design.preload, step = 1e-4 * load;
    const double difference = (end_at(load + step) - end_at(load - step)) / (2 * step);
    const double slope = differentiate(motor, std::vector{MetricRequest{Metric::plateau_speed}})[0]
                             .gradient[index_of(Parameter::preload)];
    CHECK(slopes.add(slope * load, difference * load, end) <= 1e-6);
  }
  CHECK(plateaus > 5);
}

TEST_CASE("plateau speed is where the contact stops slipping one way (T7.17)",
          "[core][metrics][identity]") {
  for (const Motor& motor : motors(7, 45, true)) {
    const MetricValue plateau = ask(motor, Metric::plateau_speed);
    REQUIRE(plateau.status == MetricStatus::ok);
    const auto slips_one_way = [&](double speed) {
      const auto zones = motor.zones(speed);
      return zones.size() == 1 && zones[0].state == ZoneState::slip_plus;
    };
    CAPTURE(plateau.value / motor.crest_speed());
    if (plateau.value > 0) {
      for (int i = 0; i < 50; ++i) CHECK(slips_one_way(plateau.value * i / 50));
      CHECK(slips_one_way(plateau.value * (1 - 1e-9)));
    }
    CHECK_FALSE(slips_one_way(plateau.value * (1 + 1e-6) + 1e-6 * motor.crest_speed()));
  }
}
