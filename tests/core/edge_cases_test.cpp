// SPDX-License-Identifier: Apache-2.0
#include "support/brute_force.hpp"
#include "support/point_checks.hpp"
#include "support/test_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/base/error.hpp>
#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>
#include <twum/core/motor_design.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

// Theory section 10, a test for each of its cases.
namespace {

using namespace twum;
using namespace twum::test;

MetricValue metric(const Motor& motor, Metric which) {
  return evaluate(motor, MetricRequest{which});
}

// Full contact and soft in shear: at rest the wave's motion stays inside the friction cone everywhere.
MotorDesign locked_motor() {
  MotorDesign design = ring_motor();
  design.layer.given_shear_modulus = 1e7;
  design.layer.given_inertia = 0;
  return at_load(design, 8);
}

}  // namespace

TEST_CASE("a motor in full contact that sticks all round is locked at rest",
          "[core][edge][limit]") {
  const Motor motor(locked_motor());
  REQUIRE(motor.contact().full);
  CHECK(motor.locks_at_rest());
  const MetricValue stall = metric(motor, Metric::stall_torque);
  const MetricValue free = metric(motor, Metric::no_load_speed);
  REQUIRE(stall.status == MetricStatus::ok);
  REQUIRE(free.status == MetricStatus::ok);
  // Creeping forwards the layer is dragged against the drive until it slips: the limit from above
  // brakes, so there is no speed to run at.
  CHECK(stall.value < 0);
  CHECK(free.value == 0);
  CHECK(metric(motor, Metric::peak_power).value == 0);
}

TEST_CASE("stall torque of a locked motor is the limit from above (T7.12)", "[core][edge][limit]") {
  const Motor motor(locked_motor());
  const double stall = metric(motor, Metric::stall_torque).value;
  double last = std::numeric_limits<double>::infinity();
  for (const double share : {1e-2, 1e-3, 1e-4, 1e-5}) {
    const auto point = motor.operating_point(share * motor.crest_speed());
    REQUIRE(point.status == PointStatus::ok);
    const double distance = std::abs(point.torque - stall) / motor.holding_torque();
    CAPTURE(share, distance);
    CHECK(distance <= last);
    last = distance;
  }
  // The approach is linear in the speed, with a slope of at most a few holding torques per V0 / r
  // times the elastic run-in of a lap.
  CHECK(last <= 1e-2);
}

TEST_CASE("a motor in partial contact does not lock", "[core][edge][limit]") {
  CHECK_FALSE(Motor(ring_motor()).locks_at_rest());
  CHECK_FALSE(Motor(at_load(ring_motor(), 0.9)).locks_at_rest());
}

TEST_CASE("without friction there is no torque", "[core][edge][limit]") {
  MotorDesign design = GENERATE(ring_motor(), damped(ring_motor()), elastic(ring_motor()));
  design.friction = {0, 0};
  const Motor motor(design);
  for (const double share : {-0.2, 0.0, 0.5, 1.0, 1.3}) {
    const auto point = motor.operating_point(share * motor.crest_speed());
    REQUIRE(point.status == PointStatus::ok);
    CHECK(point.torque == 0);
    CHECK(point.stator_power == 0);
    CHECK(point.friction_power == 0);
    CHECK(point.layer_loss == 0);
  }
  CHECK(metric(motor, Metric::stall_torque).value == 0);
  CHECK(metric(motor, Metric::no_load_speed).value == 0);
  CHECK(metric(motor, Metric::peak_power).value == 0);
  CHECK(metric(motor, Metric::holding_torque).value == 0);
}

TEST_CASE("friction of exactly one is friction like any other", "[core][edge][limit]") {
  MotorDesign one = elastic(ring_motor()), nearly = one;
  one.friction = {1, 1};
  nearly.friction = {1 - 1e-9, 1 - 1e-9};
  const double speed = 0.01 * Motor(one).crest_speed();
  const double torque = Motor(nearly).operating_point(speed).torque;
  CHECK(torque > 0);
  // Torque is at most proportional to friction, some units of which are lost with 1e-9 of it.
  CHECK(Motor(one).operating_point(speed).torque == Approx(torque).epsilon(1e-8));
}

TEST_CASE("without preload there is no torque", "[core][edge][limit]") {
  MotorDesign design = GENERATE(ring_motor(), damped(ring_motor()), elastic(ring_motor()));
  design.preload = 0;
  const Motor motor(design);
  CHECK(motor.contact().half_angle == 0);
  for (const double share : {-0.2, 0.0, 0.5, 1.0, 1.3}) {
    const auto point = motor.operating_point(share * motor.crest_speed());
    REQUIRE(point.status == PointStatus::ok);
    CHECK(all_finite(point));
    CHECK(point.torque == 0);
    CHECK(imbalance(point) == 0);
  }
  CHECK(metric(motor, Metric::stall_torque).value == 0);
}

TEST_CASE("without amplitude the contact is full and brakes any motion", "[core][edge][limit]") {
  MotorDesign design = GENERATE(ring_motor(), damped(ring_motor()), elastic(ring_motor()));
  design.stator.amplitude = 0;
  const Motor motor(design);
  CHECK(motor.contact().full);
  CHECK(motor.crest_speed() == 0);
  const double full = design.friction.kinetic * design.preload * design.stator.contact_radius;
  for (const double speed : {-20.0, -1e-3, 1e-3, 5.0, 40.0}) {
    const auto point = motor.operating_point(speed);
    CAPTURE(speed);
    REQUIRE(point.status == PointStatus::ok);
    // Uniform pressure and no drive: the layer lags behind by its full friction and stays there.
    CHECK(point.torque == Approx(speed > 0 ? -full : full).epsilon(1e-13));
    CHECK(point.friction_power == Approx(full * std::abs(speed)).epsilon(1e-13));
    CHECK(point.stator_power == 0);
  }
  CHECK(metric(motor, Metric::no_load_speed).value == 0);
}

TEST_CASE("over a still stator the rotor's direction decides which way the layer slips",
          "[core][edge][limit]") {
  MotorDesign design = ring_motor();
  design.stator.amplitude = 0;
  for (const double ratio : {1.0, 1.5}) {
    design.friction.threshold = ratio * design.friction.kinetic;
    design.layer.loss_factor = 1;  // no rhythm
    const Motor motor(design);
    for (const double speed : {-3.0, -0.5, -1e-3, 0.0, 1e-3, 0.5, 3.0}) {
      CAPTURE(ratio, speed);
      CHECK(motor.operating_point(speed).status == PointStatus::ok);
      const auto zones = motor.zones(speed);
      REQUIRE(zones.size() == 1);
      // At rest the limit of forward speeds.
      CHECK(zones[0].state == (speed < 0 ? ZoneState::slip_plus : ZoneState::slip_minus));
    }
  }
}

// A layer of uniform pressure, released at mu_0 p from a stator that stands still, by Runge and
// Kutta's method in time: the least slip velocity once it has begun to fall, over forty oscillations,
// of U.
static double least_slip_after_release(const MotorDesign& d, double speed) {
  const double m = inertia(d), c = shear_viscosity(d), g = shear_modulus(d);
  const double pressure =
      d.preload / (2 * 3.14159265358979324 * d.stator.contact_radius * d.stator.contact_width);
  const double rotor = d.stator.contact_radius * speed / d.layer.thickness;
  const double step = 1e-3 / std::max(std::sqrt(g / m), c / m);
  double x = -d.friction.threshold * pressure / g, v = -rotor, least = 1;
  const auto rate = [&](double at, double by) {
    return (-d.friction.kinetic * pressure - c * by - g * at) / m;
  };
  for (int i = 0; i < 250'000; ++i) {
    const double k1 = rate(x, v), v2 = v + step / 2 * k1;
    const double k2 = rate(x + step / 2 * v, v2), v3 = v + step / 2 * k2;
    const double k3 = rate(x + step / 2 * v2, v3), v4 = v + step * k3;
    const double k4 = rate(x + step * v3, v4);
    x += step / 6 * (v + 2 * v2 + 2 * v3 + v4);
    v += step / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    if (rate(x, v) < 0) least = std::min(least, 1 + v / rotor);
  }
  return least;
}

TEST_CASE("a layer dragged over a still stator slips steadily unless it comes back to rest",
          "[core][edge][differential]") {
  int steady = 0, rhythm = 0;
  for (const double loss : {0.003, 0.03, 0.1, 1.0}) {
    MotorDesign design = ring_motor();
    design.stator.amplitude = 0;
    design.friction = {0.2, 0.3};
    design.layer.loss_factor = loss;
    const Motor motor(design);
    for (const double speed : {0.1, 0.5, 2.0, 10.0}) {
      const double least = least_slip_after_release(design, speed);
      CAPTURE(loss, speed, least);
      if (std::abs(least) < 1e-6) continue;  // too close to tell by steps in time
      ++(least > 0 ? steady : rhythm);
      // Over a stator without a wave both directions are the same.
      for (const double signed_speed : {speed, -speed})
        CHECK(motor.operating_point(signed_speed).status ==
              (least > 0 ? PointStatus::ok : PointStatus::no_periodic_state));
    }
  }
  CHECK(steady > 0);
  CHECK(rhythm > 0);
}

TEST_CASE(
    "an elastic layer with a static threshold snaps, and the work of every snap counts (T4.4)",
    "[core][edge][identity]") {
  MotorDesign design = at_load(elastic(ring_motor()), 0.15);
  design.friction.threshold = 1.8 * design.friction.kinetic;
  const Motor motor(design);
  int differing = 0;
  for (const double share : {0.5, 0.7, 0.8, 0.9, 0.95, 1.0, 1.1, 1.3}) {
    const double speed = share * motor.crest_speed();
    const auto point = motor.operating_point(speed);
    const auto oracle = brute_force(design, speed);
    CAPTURE(share);
    REQUIRE(point.status == PointStatus::ok);
    CHECK(std::abs(imbalance(point)) <= 1e-12 * power_scale(motor, speed));
    CHECK(std::abs(point.torque - oracle.torque) <= oracle.torque_error);
    CHECK(std::abs(point.friction_power - oracle.friction_power) <= oracle.power_error);
    MotorDesign kinetic = design;
    kinetic.friction.threshold = kinetic.friction.kinetic;
    differing += std::abs(Motor(kinetic).operating_point(speed).torque - point.torque) >
                 1e-3 * motor.holding_torque();
  }
  CHECK(differing >= 3);  // the threshold matters at these speeds
}

TEST_CASE("a period-one state that does not exist is reported, not invented",
          "[core][edge][limit]") {
  // Full contact, elastic, mu_0 > mu: the layer's state at "entry" depends on where it last snapped.
  MotorDesign design = GENERATE(damped(ring_motor()), elastic(ring_motor()));
  design.layer.given_shear_modulus = 0.3 * shear_modulus(design);
  design = at_load(design, 3);
  design.friction.threshold = 1.7 * design.friction.kinetic;
  const Motor motor(design);
  int absent = 0;
  for (int i = 1; i <= 40; ++i) {
    const double speed = motor.crest_speed() * 0.03 * i;
    const auto point = motor.operating_point(speed);
    CAPTURE(i);
    // laps by time stepping settle if and only if the core has a state
    if (i % 4 == 1)
      CHECK(fixed_grid(design, speed, 1000, 400).converged == (point.status == PointStatus::ok));
    if (point.status == PointStatus::ok) {
      CHECK(all_finite(point));
      CHECK(std::abs(imbalance(point)) <= 1e-11 * power_scale(motor, speed));
      continue;
    }
    ++absent;
    CHECK(point.status == PointStatus::no_periodic_state);
    CHECK(point.speed == speed);
    CHECK(std::isnan(point.torque));
    CHECK(std::isnan(point.friction_power));
    CHECK(motor.zones(speed).empty());
    const MetricValue value = evaluate(motor, {Metric::torque_at, Argument::speed, speed});
    CHECK(value.status == MetricStatus::no_periodic_state);
    CHECK(std::isnan(value.value));
    const SpeedDerivative slopes = differentiate_in_speed(motor, speed);
    CHECK(slopes.smoothness == Smoothness::undefined);
    for (const double each : {slopes.torque, slopes.output_power, slopes.stator_power,
                              slopes.friction_power, slopes.layer_loss, slopes.stick_fraction})
      CHECK(std::isnan(each));
  }
  CHECK(absent > 0);
}

TEST_CASE("an undamped layer with inertia has an answer or a typed reason", "[core][edge][limit]") {
  MotorDesign design = ring_motor();
  design.layer.given_shear_viscosity = 0;
  for (const double load : {0.02, 0.3, 0.9, 1.5}) {
    const Motor motor(at_load(design, load));
    for (const double share : {-0.2, 0.0, 0.4, 0.8, 0.95, 1.2}) {
      const auto point = motor.operating_point(share * motor.crest_speed());
      CAPTURE(load, share, to_string(point.status));
      if (point.status == PointStatus::ok) {
        CHECK(std::abs(imbalance(point)) <= 1e-10 * power_scale(motor, point.speed));
        CHECK(point.layer_loss == 0);
      } else {
        CHECK(std::isnan(point.torque));
      }
    }
  }
}

TEST_CASE("an undamped layer driven at its own resonance is refused by name",
          "[core][edge][limit]") {
  // Full slip with M = m W^2 = G: the forced response has no bound.
  MotorDesign design = at_load(ring_motor(), 2.0);
  const double omega = 2 * 3.14159265358979323846 * design.stator.frequency;
  design.layer.given_shear_modulus = 1e9;
  design.layer.given_shear_viscosity = 0;
  design.layer.given_inertia = 1e9 / (omega * omega);
  const auto point = Motor(design).operating_point(0);
  CAPTURE(to_string(point.status));
  if (point.status == PointStatus::ok) {
    CHECK(all_finite(point));
  } else {
    CHECK((point.status == PointStatus::resonance || point.status == PointStatus::not_converged ||
           point.status == PointStatus::no_periodic_state));
  }
}

TEST_CASE("overhauling and backward running are operating points", "[core][edge][identity]") {
  const Motor motor(ring_motor());
  const double full = 0.2 * 160 * 0.0265;
  for (const double share : {-5.0, -0.5, -0.01}) {
    const auto point = motor.operating_point(share * motor.crest_speed());
    REQUIRE(point.status == PointStatus::ok);
    CHECK(point.torque ==
          Approx(full).epsilon(1e-12));  // the wave drives a rotor that runs backward
    CHECK(point.output_power < 0);
  }
  for (const double share : {1.5, 5.0, 40.0}) {
    const auto point = motor.operating_point(share * motor.crest_speed());
    REQUIRE(point.status == PointStatus::ok);
    CHECK(point.torque == Approx(-full).epsilon(1e-12));  // and brakes one that overhauls
    CHECK(std::abs(imbalance(point)) <= 1e-11 * power_scale(motor, point.speed));
  }
}

TEST_CASE("speeds down to just above the negative wave speed are answered (T2.1)",
          "[core][edge][limit]") {
  const Motor motor(ring_motor());
  const auto point = motor.operating_point(-motor.wave_speed() * (1 - 1e-6));
  REQUIRE(point.status == PointStatus::ok);
  CHECK(point.torque == Approx(0.2 * 160 * 0.0265).epsilon(1e-12));
}

TEST_CASE("full contact is answered at very low speed, where laps hardly differ",
          "[core][edge][differential]") {
  for (const MotorDesign& base : {ring_motor(), damped(ring_motor()), elastic(ring_motor())}) {
    const Motor motor(at_load(base, 1.2));
    for (const double share : {1e-7, 1e-5, 1e-4, 1e-3}) {
      const auto point = motor.operating_point(share * motor.crest_speed());
      CAPTURE(share);
      REQUIRE(point.status == PointStatus::ok);
      CHECK(std::abs(imbalance(point)) <= 1e-11 * power_scale(motor, point.speed));
    }
    const double speed = 0.02 * motor.crest_speed();
    const auto oracle = brute_force(motor.design(), speed);
    REQUIRE(oracle.converged);
    CHECK(std::abs(motor.operating_point(speed).torque - oracle.torque) <= oracle.torque_error);
  }
}

TEST_CASE("a lightly damped layer finds its periodic state (E6.2)", "[core][edge][differential]") {
  MotorDesign design = ring_motor();
  design.layer.loss_factor = 0.001;
  design.layer.given_inertia = 5e-4;  // slow enough to be still ringing at the next entry
  const Motor motor(design);
  for (const double share : {0.0, 0.3, 0.8, 1.2}) {
    const double speed = share * motor.crest_speed();
    const auto point = motor.operating_point(speed);
    const auto oracle = brute_force(design, speed);
    CAPTURE(share, oracle.laps);
    REQUIRE(point.status == PointStatus::ok);
    CHECK(std::abs(point.torque - oracle.torque) <= oracle.torque_error);
    CHECK(std::abs(point.layer_loss - oracle.layer_loss) <= oracle.power_error);
  }
}
