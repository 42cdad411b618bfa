// SPDX-License-Identifier: Apache-2.0
// Loads where torque jumps, which takes mu_0 > mu.
#include "core/curve_motors.hpp"
#include "support/driven_motors.hpp"
#include "support/test_motors.hpp"

#include <twum/core/metrics.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace twum;
using namespace twum::test;

namespace {

// Ring motors with heavy, lightly damped layers; torque falls by jumps in one of some hundred.
MotorDesign jumping_motor(int number) {
  Uniform random(54);
  MotorDesign design;
  for (int i = 0; i <= number; ++i) {
    design = ring_motor();
    design.layer.loss_factor = 0.002 * (1 + i % 10);
    design.layer.given_inertia = std::pow(10, random(-4.3, -2.3));
    design.preload *= std::pow(10, random(-1.3, 0.7));
    design.friction.threshold = design.friction.kinetic * random(1.02, 2.5);
  }
  return design;
}

}  // namespace

TEST_CASE("a load that torque jumps past is met at the jump (T7.15)", "[core][metrics][limit]") {
  const Motor motor(jumping_motor(170));
  const double unit = motor.holding_torque();
  const auto torque_at = [&](double speed) { return motor.operating_point(speed).torque; };
  // Halving between two speeds: the jump from 0.32 to 0.13 of the holding torque.
  const double free = ask(motor, Metric::no_load_speed).value;
  double low = 0.6 * free, high = 0.7 * free;
  while (low < 0.5 * (low + high) && 0.5 * (low + high) < high)
    (torque_at(0.5 * (low + high)) > 0.2 * unit ? low : high) = 0.5 * (low + high);
  REQUIRE(torque_at(low) - torque_at(high) > 0.1 * unit);
  for (const double load : {0.15 * unit, 0.2 * unit, 0.3 * unit}) {
    const MetricDerivative answer =
        differentiated(motor, {Metric::speed_at, Argument::torque, load});
    const MetricValue& found = answer.value;
    CAPTURE(found.value - low);
    // The state ends where its zones do, which rounding of the state tells to 1e-12 or so.
    CHECK(found.value == Approx(low).epsilon(1e-11));
    CHECK(torque_at(found.value) >= load);  // on the side that carries the load
    CHECK(answer.smoothness == Smoothness::undefined);
  }
}

TEST_CASE("where torque jumps past zero the no-load speed carries every smaller load (T7.15)",
          "[core][metrics][limit]") {
  const Motor motor(jumping_motor(240));
  const double free = ask(motor, Metric::no_load_speed).value;
  const double beside = motor.operating_point(free).torque;
  REQUIRE(beside > 1e-4 * motor.holding_torque());
  REQUIRE(motor.operating_point(free * (1 + 1e-14)).torque < 0);
  for (const double share : {1e-3, 0.5, 0.999})
    CHECK(ask_at_torque(motor, Metric::speed_at, share * beside).value == free);
  for (const double share : {1.5, 3.0}) {
    const double load = share * beside, speed = ask_at_torque(motor, Metric::speed_at, load).value;
    CHECK(speed < free);
    // A root in speed, some eps of it, and a slope of up to 1e5 holding torques per V0 / r.
    CHECK(std::abs(motor.operating_point(speed).torque - load) <= 1e-9 * motor.holding_torque());
  }
}

TEST_CASE("a slice that jumps under a voltage leaves its neighbours' maximum (T7.15)",
          "[core][metrics][driven]") {
  // At a speed where a slice jumps the wave may have no balance.
  MotorDesign design = driven_motor_with_layer();
  design.stator.contact_width = 3.05319e-3;
  design.stator.frequency = 40'524.518;
  design.stator.voltage = 93.9577;
  design.stator.quality_factor = 209.202;
  design.layer.thickness = 0.594026e-3;
  design.layer.youngs_modulus = 1.07046e9;
  design.layer.loss_factor = 0.158992;
  design.friction = {0.260522, 0.331714};
  design.preload = 116.541;
  design.stator.radial_slices = 8;
  const Motor motor(design);
  const double free = ask(motor, Metric::no_load_speed).value;
  double torque = 0, power = 0;
  for (int i = 0; i <= 1000; ++i) {
    const OperatingPoint p = motor.operating_point(free * i / 1000);
    if (p.status != PointStatus::ok) continue;
    torque = std::max(torque, p.torque), power = std::max(power, p.torque * p.speed);
  }
  const double most = ask(motor, Metric::max_torque).value,
               peak = ask(motor, Metric::peak_power).value;
  // A slice that jumps between two samples adds at most its share of the load, up to 0.18 by Gauss' rule, times
  // (mu_0 - mu) / mu = 0.27: 5 % of the torque. The bound is narrower.
  CHECK((most >= torque && most <= 1.034 * torque));
  CHECK((peak >= power && peak <= 1.034 * power));
}
