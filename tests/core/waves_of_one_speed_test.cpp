// SPDX-License-Identifier: Apache-2.0
#include "support/driven_motors.hpp"
#include "support/metric_requests.hpp"

#include <catch2/catch.hpp>

#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>

#include <cmath>

// Metrics of one speed are found from the waves of that speed; those of a motor's points from its whole curve of waves.
namespace {

using namespace twum;
using namespace twum::test;

MotorDesign random_driven(Uniform& random) {
  MotorDesign design = random.chance(0.4) ? driven_motor() : driven_motor_with_layer();
  Stator& s = design.stator;
  s.frequency = 39e3 * (random.chance(0.15) ? random(0.97, 1) : 1 + random.logarithmic(1e-3, 0.25));
  s.voltage = random.logarithmic(5, 400);
  s.modal_damping = random.logarithmic(4, 300);
  design.preload = random.logarithmic(8, 500);
  design.friction.kinetic = design.friction.threshold = random(0.05, 0.5);
  design.layer.thickness = random.logarithmic(0.1e-3, 3e-3);
  design.layer.youngs_modulus = random.logarithmic(5e7, 6e9);
  if (random.chance(0.6)) design.layer.loss_factor = random.logarithmic(0.005, 0.3);
  return design;
}

bool same_torque(const MotorDesign& design, double speed) {
  const MetricValue alone = evaluate(Motor(design), {Metric::torque_at, Argument::speed, speed});
  const OperatingPoint of_curve = Motor(design).operating_point(speed);
  const bool answered = alone.status == MetricStatus::ok;
  CHECK(answered == (of_curve.status == PointStatus::ok));
  if (!answered) return false;
  // Both amplitudes are right to 1e-12; over them the torque changes by up to a hundred times its own size.
  const double scale = design.friction.threshold * design.preload * design.stator.contact_radius;
  CHECK(std::fabs(alone.value - of_curve.torque) < 1e-10 * scale);
  return true;
}

}  // namespace

TEST_CASE("the waves of one speed tell the running branch as the whole curve does",
          "[core][driven][identity]") {
  Uniform random(4711);
  int answered = 0;
  for (int i = 0; i < 400; ++i) {
    MotorDesign design = random_driven(random);
    if (i % 10 == 9) design.stator.radial_slices = -6;
    const double speed =
        random.chance(0.2) ? random.logarithmic(1e-3, 2) : random.logarithmic(0.5, 60);
    CAPTURE(i, speed);
    answered += same_torque(design, speed) ? 1 : 0;
  }
  CHECK(answered > 200);
}

TEST_CASE("a wave of a dead piece from rest does not run at any speed", "[core][driven][limit]") {
  // From rest to 9.8 rad/s without a fold, beyond 5.4 with R <= 0 and as the largest wave: one that the motor has at rest as well.
  MotorDesign design = driven_motor_with_layer(14.748371140767096, 39879.504034561753);
  design.stator.modal_damping = 6.8257936112699333;
  design.preload = 131.61544045123028;
  design.friction = {0.42334709883137672, 0.42334709883137672};
  design.layer.thickness = 0.34333443943056181e-3;
  design.layer.youngs_modulus = 74232309.731264457;
  design.layer.loss_factor = 0.0052516282726146161;
  for (const double speed : {0.0, 4.0, 6.0, 8.0, 9.6432366577281208}) {
    CAPTURE(speed);
    CHECK(!same_torque(design, speed));
    const auto states = Motor(design).wave_states(speed);
    REQUIRE(!states.empty());
    CHECK(states.back().stable);
    CHECK(!states.back().running);
  }
}
