// SPDX-License-Identifier: Apache-2.0
#include "support/ode_solver.hpp"
#include "support/deviations.hpp"
#include "support/point_checks.hpp"
#include "support/test_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/core/motor.hpp>

#include <algorithm>

// The core against a general ODE solver with event location: the sharpest of the oracles.
namespace {

using namespace twum;
using namespace twum::test;

}  // namespace

TEST_CASE(
    "a general ODE solver finds the same torque and powers (T4.1, T4.2, T4.3, T4.5, T7.2, T7.3, "
    "T7.4)",
    "[core][point][differential]") {
  // The solver keeps 1e-13 a step over some hundreds of steps a lap: 1e-10 of the scale; its own
  // estimate says where a nearly double root makes it worse.
  Deviation torque("torque against the ODE solver, of mu_0 F_N r", 1e-10);
  Deviation powers("powers against the ODE solver, of their scale", 1e-10);
  Uniform random(31337);
  int compared = 0;
  for (int i = 0; i < 60; ++i) {
    MotorDesign design = realistic_design(random);
    if (i % 2 == 1) design = damped(design);
    if (i % 5 == 4) design.preload = full_contact_load(design) * random(1.05, 3.0);
    if (i % 4 >= 2) design.friction.threshold = design.friction.kinetic * random(1.1, 2.0);
    const Motor motor(design);
    for (int k = 0; k < 3; ++k) {
      const double speed = motor.crest_speed() * random(-0.2, 1.3);
      const auto point = motor.operating_point(speed);
      const auto oracle = ode_solver(design, speed, {.max_laps = 500});
      CAPTURE(i, speed, motor.contact().half_angle, to_string(point.status), oracle.laps);
      if (!oracle.converged) continue;
      REQUIRE(point.status == PointStatus::ok);
      ++compared;
      const double power = power_scale(motor, speed);
      const double allowed = std::max(1e-10, 3 * oracle.torque_error / torque_scale(design));
      const double allowed_power = std::max(1e-10, 3 * oracle.power_error / power);
      CHECK(torque.add(point.torque, oracle.torque, torque_scale(design)) <= allowed);
      CHECK(powers.add(point.stator_power, oracle.stator_power, power) <= allowed_power);
      CHECK(powers.add(point.friction_power, oracle.friction_power, power) <= allowed_power);
      CHECK(powers.add(point.layer_loss, oracle.layer_loss, power) <= allowed_power);
    }
  }
  CHECK(compared >= 150);
}
