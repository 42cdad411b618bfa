// SPDX-License-Identifier: Apache-2.0
#include "support/point_checks.hpp"
#include "support/test_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>
#include <twum/core/parameters.hpp>

#include <cmath>
#include <span>
#include <utility>

// Motors without wave, friction or preload, and those that only look like one.
namespace {

using namespace twum;
using namespace twum::test;

MetricDerivative holding_torque_of(const MotorDesign& design, bool fixed_static_friction) {
  const MetricRequest request{Metric::holding_torque};
  return differentiate(Motor(design), std::span(&request, 1), fixed_static_friction).front();
}

}  // namespace

TEST_CASE("a preload of exactly one newton is a preload like any other", "[core][edge][limit]") {
  for (const MotorDesign& base : {ring_motor(), damped(ring_motor()), elastic(ring_motor())}) {
    MotorDesign one = base, nearly = base;
    one.preload = 1;
    nearly.preload = 1 - 1e-9;
    const double speed = 0.01 * Motor(one).crest_speed();
    const auto point = Motor(one).operating_point(speed),
               beside = Motor(nearly).operating_point(speed);
    REQUIRE(point.status == PointStatus::ok);
    REQUIRE(beside.status == PointStatus::ok);
    CHECK(beside.torque > 0);
    // Torque goes with some power of the preload of order one, some units of which are lost with 1e-9 of it.
    CHECK(point.torque == Approx(beside.torque).epsilon(1e-8));
    CHECK(point.friction_power == Approx(beside.friction_power).epsilon(1e-8));
  }
}

TEST_CASE("over a still stator a layer without damping slips steadily if mu_0 = mu",
          "[core][edge][closed_form]") {
  // Released at mu p from rest on the stator it swings about that traction by no more than the velocity it is
  // dragged with, so it comes back to rest at the most for a moment, and no threshold holds it there.
  for (int i = 1; i <= 300; ++i) {
    MotorDesign design = ring_motor();
    design.stator.amplitude = 0;
    design.friction.threshold = design.friction.kinetic;
    design.layer.loss_factor = 0;
    design.layer.thickness = 1e-4 * (1 + i % 7);
    const Motor motor(design);
    for (const double speed : {0.37 * i, -0.37 * i}) {
      const auto point = motor.operating_point(speed);
      CAPTURE(design.layer.thickness, speed);
      REQUIRE(point.status == PointStatus::ok);
      // Coulomb's law, a product of three factors.
      CHECK(point.torque ==
            Approx(speed > 0 ? -torque_scale(design) : torque_scale(design)).epsilon(1e-15));
    }
  }
}

TEST_CASE("without friction the holding torque grows with friction as that of a little does (T7.8)",
          "[core][derivative][limit]") {
  for (const double mu : {0.0, 1e-9, 0.2}) {
    MotorDesign design = ring_motor();
    design.friction = {mu, mu};
    const double arm = design.preload * design.stator.contact_radius;
    const std::size_t kinetic = index_of(Parameter::kinetic_friction);
    const std::size_t fixed = index_of(Parameter::static_friction);
    CAPTURE(mu);
    // mu_0 F_N r with mu_0 = mu, which move together unless mu_0 is held.
    CHECK(holding_torque_of(design, false).gradient[kinetic] == Approx(arm).epsilon(1e-15));
    CHECK(holding_torque_of(design, true).gradient[kinetic] == 0);
    CHECK(holding_torque_of(design, true).gradient[fixed] == Approx(arm).epsilon(1e-15));
  }
}

TEST_CASE("a motor that was moved from is still that motor", "[core][edge]") {
  Motor first{MotorDesign{}};
  const double torque = first.operating_point(5).torque;
  const Motor second(std::move(first));
  CHECK(first.operating_point(5).torque == torque);  // NOLINT(bugprone-use-after-move)
  CHECK(second.operating_point(5).torque == torque);
}

TEST_CASE("motors are equal if their designs are", "[core][edge]") {
  CHECK(Motor(MotorDesign{}) == Motor(MotorDesign{}));
  for (const Parameter p : {Parameter::preload, Parameter::thickness, Parameter::kinetic_friction,
                            Parameter::contact_radius})
    CHECK(MotorDesign{} != with(MotorDesign{}, p, 1.001 * get(MotorDesign{}, p)));
}

TEST_CASE("the derivative of one metric is that of a list of one", "[core][derivative]") {
  const Motor motor{MotorDesign{}};
  const MetricRequest request{Metric::torque_at, Argument::speed, 5};
  const MetricDerivative alone = differentiate(motor, request);
  const MetricDerivative first = differentiate(motor, std::span(&request, 1)).front();
  CHECK(alone.value.value == first.value.value);
  CHECK(alone.gradient == first.gradient);
}
