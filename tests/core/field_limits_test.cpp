// SPDX-License-Identifier: Apache-2.0
#include "support/contact_problem.hpp"
#include "support/test_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/core/motor.hpp>
#include <twum/core/motor_design.hpp>

#include <cmath>

// Fields where amplitude, preload or friction is zero.

using namespace twum;
using namespace twum::test;

TEST_CASE("over a flat stator the layer hangs back evenly", "[core][fields][closed_form]") {
  MotorDesign design = GENERATE(ring_motor(), damped(ring_motor()), elastic(ring_motor()));
  design.stator.amplitude = 0;
  const Motor motor(design);
  for (const double speed : {-5.0, 5.0}) {
    const ContactFields fields = motor.fields(speed, 10);
    const ContactProblem problem = contact_problem(design, speed);
    const double pressure = design.preload / problem.track_area;
    const double traction = -std::copysign(design.friction.kinetic * pressure, speed);
    REQUIRE(fields.zones.size() == 1);
    CHECK(fields.zones[0].state == (speed > 0 ? ZoneState::slip_minus : ZoneState::slip_plus));
    for (const FieldSample& s : fields.samples) {
      // Products of a few numbers: a few eps.
      CHECK(s.pressure == Approx(pressure).epsilon(1e-14));
      CHECK(s.traction == Approx(traction).epsilon(1e-14));
      // At rest in the layer nothing but its stiffness pulls.
      CHECK(problem.stiffness * s.displacement / design.layer.thickness ==
            Approx(traction).epsilon(1e-14));
      CHECK(s.stator_velocity == 0);
      CHECK(s.layer_velocity == Approx(problem.rotor_velocity).epsilon(1e-14));
    }
  }
}

TEST_CASE("a motor without preload has neither zones nor traction", "[core][fields][limit]") {
  MotorDesign design = ring_motor();
  design.preload = 0;
  const ContactFields fields = Motor(design).fields(10.0, 10);
  CHECK(fields.zones.empty());
  for (const FieldSample& s : fields.samples) {
    CHECK(s.pressure == 0);
    CHECK(s.traction == 0);
    CHECK(s.displacement == 0);
  }
}

TEST_CASE("without friction the contact presses all the same (T3.1, T3.3)",
          "[core][fields][limit]") {
  for (const double load : {0.05, 0.5, 1.5}) {
    MotorDesign design = at_load(ring_motor(), load);
    const ContactFields rough = Motor(design).fields(10.0, 101);
    design.friction = {0, 0};
    const Motor motor(design);
    const ContactFields smooth = motor.fields(10.0, 101);
    REQUIRE(smooth.zones.size() == 1);
    CHECK(smooth.zones[0].state != ZoneState::stick);
    CHECK(smooth.zones[0].from == -motor.contact().half_angle);
    CHECK(smooth.zones[0].to == motor.contact().half_angle);
    for (std::size_t i = 0; i < smooth.samples.size(); ++i) {
      const FieldSample& s = smooth.samples[i];
      CHECK(s.pressure == rough.samples[i].pressure);
      CHECK(s.stator_velocity == rough.samples[i].stator_velocity);
      CHECK(s.traction == 0);
      CHECK(s.displacement == 0);
      CHECK(s.layer_velocity == 10.0 * design.stator.contact_radius);
    }
  }
}

TEST_CASE("fields of fewer than two samples are refused", "[core][fields][error]") {
  const Motor motor(ring_motor());
  for (const int samples : {1, 0, -3})
    CHECK_THROWS_WITH(motor.fields(10.0, samples), Catch::Matchers::Contains("at least 2 samples"));
  CHECK(motor.fields(10.0, 2).samples.size() == 2);
}
