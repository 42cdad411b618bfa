// SPDX-License-Identifier: Apache-2.0
#include "support/brute_force.hpp"
#include "support/deviations.hpp"
#include "support/point_checks.hpp"
#include "support/test_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/core/motor.hpp>

#include <algorithm>
#include <vector>

// The core against time stepping, on designs that no one chose by hand.
namespace {

using namespace twum;
using namespace twum::test;

// Realistic designs of every kind of layer, threshold and contact, in turn. Layers much faster than the
// wave are left to the ODE oracle: the trapezoidal rule would need a million steps for them.
MotorDesign seeded_design(Uniform& random, int index) {
  MotorDesign design = realistic_design(random);
  const bool threshold = index / 3 % 2 == 1;
  design.friction.threshold = design.friction.kinetic * (threshold ? random(1.1, 2.0) : 1.0);
  if (index % 5 == 4) design.preload = full_contact_load(design) * random(1.05, 3.0);
  if (index % 3 == 1) design = damped(design);
  if (index % 3 == 2) design = elastic(design);
  if (index % 3 == 0) design.layer.thickness = random(0.3e-3, 0.8e-3);
  return design;
}

}  // namespace

TEST_CASE("time stepping finds the same torque and powers (T4.1, T4.2, T4.3, T4.5)",
          "[slow][core][point][differential]") {
  // The tolerance is the oracle's own error estimate; brute_force.hpp says how it is made.
  Deviation torque("torque against brute force, in units of its error estimate", 1);
  Deviation absolute("torque against brute force, of mu_0 F_N r", 1e-3);
  Deviation powers("powers against brute force, in units of its error estimate", 1);
  Uniform random(987654321);
  int compared = 0;
  int absent = 0;
  for (int i = 0; i < 40; ++i) {
    const MotorDesign design = seeded_design(random, i);
    const Motor motor(design);
    for (int k = 0; k < 2; ++k) {
      const double speed = motor.crest_speed() * (k == 0 ? random(0.02, 0.9) : random(0.85, 1.3));
      const auto point = motor.operating_point(speed);
      const auto oracle = brute_force(design, speed, {2000, 3000});
      CAPTURE(i, speed, motor.contact().half_angle, to_string(point.status), oracle.laps,
              oracle.converged);
      if (point.status == PointStatus::no_periodic_state) {
        CHECK_FALSE(oracle.converged);
        ++absent;
        continue;
      }
      REQUIRE(point.status == PointStatus::ok);
      if (!oracle.converged) continue;
      ++compared;
      absolute.add(point.torque, oracle.torque, torque_scale(design));
      CAPTURE(oracle.torque_error / torque_scale(design),
              (point.torque - oracle.torque) / torque_scale(design));
      CHECK(torque.add(point.torque, oracle.torque, oracle.torque_error) <= 1);
      CHECK(powers.add(point.stator_power, oracle.stator_power, oracle.power_error) <= 1);
      CHECK(powers.add(point.friction_power, oracle.friction_power, oracle.power_error) <= 1);
      CHECK(powers.add(point.layer_loss, oracle.layer_loss, oracle.power_error) <= 1);
    }
  }
  CAPTURE(absent);
  CHECK(compared >= 60);
  CHECK(torque.holds());
  CHECK(absolute.holds());
}

TEST_CASE("time stepping converges with second order to the core's torque",
          "[core][oracle][limit]") {
  const Motor motor(damped(ring_motor()));
  const double speed = 0.9 * motor.crest_speed();
  const double exact = motor.operating_point(speed).torque;
  const double coarse = fixed_grid(motor.design(), speed, 4000).torque - exact;
  const double fine = fixed_grid(motor.design(), speed, 16000).torque - exact;
  // a fourfold refinement divides the error by sixteen, events placed at grid points aside
  Deviation order("time stepping converges with order two to the core, ratio 16", 0.5);
  CHECK(order.add(coarse / fine, 16, 16) <= 0.5);
}
