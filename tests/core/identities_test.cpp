// SPDX-License-Identifier: Apache-2.0
#include "case_file.hpp"
#include "support/constants.hpp"
#include "support/deviations.hpp"
#include "support/point_checks.hpp"
#include "support/test_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/core/motor.hpp>
#include <twum/core/motor_design.hpp>

#include <algorithm>

namespace {

using namespace twum;
using namespace twum::test;

std::vector<IdentityCase> cases() {
  return read_identity_cases(TWUM_SOURCE_DIR "/tests/core/identity_cases.yaml");
}

// Runs a check at every motor and speed of the case file.
template <typename Check>
void for_each_point(Check check) {
  for (const IdentityCase& entry : cases()) {
    const Motor motor(entry.design);
    for (const double speed : entry.speeds) {
      CAPTURE(entry.motor, speed / motor.crest_speed());
      const OperatingPoint point = motor.operating_point(speed);
      REQUIRE(point.status == PointStatus::ok);
      check(motor, point);
    }
  }
}

}  // namespace

TEST_CASE("input power is output plus losses (T7.10)", "[core][point][identity]") {
  // Every integral is that of the exact motion, so what remains is rounding: a few dozen terms of the
  // scale at eps = 2e-16, amplified by the condition of the periodic state, at most 1e3 for a loss
  // factor of 0.001. 1e-11 leaves a factor of ten.
  Deviation identity("identity at the case file's points", 1e-11);
  for_each_point([&](const Motor& motor, const OperatingPoint& point) {
    CHECK(identity.add(imbalance(point), 0, power_scale(motor, point.speed)) <= 1e-11);
  });
  CHECK(identity.holds());
}

TEST_CASE("the identity outlasts the digits of a narrow contact (T7.10)", "[core][point][limit]") {
  Deviation identity("identity of contacts 1e-4 to 6e-3 rad narrow, in units of their rounding", 1);
  for (const double load : {1e-8, 1e-10, 1e-12}) {
    MotorDesign design = ring_motor();
    design.preload = load * full_contact_load(design);
    const Motor motor(design);
    const double half = motor.contact().half_angle;
    for (const double offset : {-3.0, -0.5, -0.1, 0.0, 0.1, 0.5, 3.0}) {
      const auto point = motor.operating_point((1 + offset * half) * motor.crest_speed());
      CAPTURE(load, offset, half);
      REQUIRE(point.status == PointStatus::ok);
      // Speeds 1 - V are of the order theta_L, known to eps; cos theta - c is of the order
      // theta_L^2: a relative error of 10 eps / theta_L^2.
      CHECK(identity.add(imbalance(point), 0,
                         (1e-11 + 2e-15 / (half * half)) * power_scale(motor, point.speed)) <= 1);
      CHECK(std::abs(point.torque) <= motor.holding_torque() * (1 + 2e-15 / (half * half)));
    }
  }
}

TEST_CASE("narrow contacts of layers soft and stiff in shear keep the identity (T7.10)",
          "[core][point][limit]") {
  Deviation identity(
      "identity of narrow contacts, G of 1e-3 to 1e2 its own, in units of their rounding", 1);
  for (const double ratio : {1e2, 10.0, 1.0, 1e-2, 1e-3}) {
    for (const bool inertial : {true, false}) {
      MotorDesign design = ring_motor();
      design.layer.given_shear_modulus = ratio * shear_modulus(design);
      design.layer.given_inertia = inertial ? ratio * inertia(design) : 0;
      design.layer.loss_factor = inertial ? 0.05 : 0.5;
      for (const double load : {1e-5, 1e-6, 1e-7, 1e-8, 1e-10}) {
        design.preload = load * full_contact_load(design);
        const Motor motor(design);
        const double half = motor.contact().half_angle;
        for (const double offset : {-3.0, -0.5, -0.1, 0.0, 0.1, 0.5, 3.0}) {
          const auto point = motor.operating_point((1 + offset * half) * motor.crest_speed());
          CAPTURE(ratio, inertial, load, offset, half);
          REQUIRE(point.status == PointStatus::ok);
          // Speeds near the wave's are known to eps = 2e-16, and so are the phases of zones, where pressures
          // are of the order theta_L^2: 5e-16 / theta_L^2 for both. All else is rounding of a few dozen terms,
          // whatever the layer.
          CHECK(identity.add(imbalance(point), 0,
                             (1e-12 + 5e-16 / (half * half)) * power_scale(motor, point.speed)) <=
                1);
        }
      }
    }
  }
  CHECK(identity.holds());
}

TEST_CASE("input power is output plus losses on random realistic motors (T7.10)",
          "[core][point][identity]") {
  Deviation identity("identity on 300 realistic designs x 6 speeds", 1e-11);
  Uniform random(20240611);
  int answered = 0;
  for (int i = 0; i < 300; ++i) {
    const Motor motor(realistic_design(random));
    for (int k = 0; k < 6; ++k) {
      const auto point = motor.operating_point(motor.crest_speed() * random(-0.3, 1.5));
      if (point.status != PointStatus::ok) continue;
      ++answered;
      identity.add(imbalance(point), 0, power_scale(motor, point.speed));
    }
  }
  CHECK(answered >= 1750);
  CAPTURE(identity.largest());
  CHECK(identity.holds());
}

TEST_CASE("no torque exceeds the holding torque (C8.1, T7.8)", "[core][point][identity]") {
  Deviation bound("torque beyond mu_0 F_N r, of it", 1e-13);
  for_each_point([&](const Motor& motor, const OperatingPoint& point) {
    CHECK(motor.holding_torque() == Approx(torque_scale(motor.design())).epsilon(1e-15));
    // The mean of tau is a sum of zone integrals, each rounded to a few eps.
    const double excess = std::max(0.0, std::abs(point.torque) - motor.holding_torque());
    CHECK(bound.add(excess, 0, motor.holding_torque()) <= 1e-13);
  });
}

TEST_CASE("friction and the layer only take power (T7.3, T7.4)", "[core][point][identity]") {
  Deviation negative("friction power and layer loss below zero, of their scale", 1e-13);
  for_each_point([&](const Motor& motor, const OperatingPoint& point) {
    // Exact values are never negative; rounding of sums of the scale may show where they are zero.
    const double scale = power_scale(motor, point.speed);
    CHECK(negative.add(std::max(0.0, -point.friction_power), 0, scale) <= 1e-13);
    CHECK(negative.add(std::max(0.0, -point.layer_loss), 0, scale) <= 1e-13);
  });
}

TEST_CASE("the numbers of a point fit together (T7.1, T7.5, T7.6, T7.7, T7.9)",
          "[core][point][identity]") {
  MotorDesign design = ring_motor();
  design.stator.modal_damping = 45;
  const Motor motor(design);
  const auto point = motor.operating_point(12.0);
  const double omega = 2 * kPi * design.stator.frequency;
  const double track = 2 * kPi * design.stator.contact_radius * design.stator.contact_width;
  // Products of a handful of factors: a few eps each.
  CHECK(point.speed == 12.0);
  CHECK(point.output_power == Approx(point.torque * 12.0).epsilon(1e-15));
  CHECK(point.stator_loss ==
        Approx(45 * std::pow(omega * design.stator.amplitude, 2)).epsilon(1e-14));
  CHECK(point.wear_intensity == Approx(point.friction_power / track).epsilon(1e-14));
  CHECK(point.contact_efficiency() ==
        Approx(point.output_power / point.stator_power).epsilon(1e-15));
  CHECK(point.efficiency() ==
        Approx(point.output_power / (point.stator_power + point.stator_loss)).epsilon(1e-15));
}

TEST_CASE("efficiencies are not numbers where no power is put in (T7.6, T7.7)",
          "[core][point][limit]") {
  const Motor motor(ring_motor());
  const auto braked = motor.operating_point(1.5 * motor.crest_speed());
  REQUIRE(braked.stator_power < 0);
  CHECK(std::isnan(braked.contact_efficiency()));
  CHECK(std::isnan(braked.efficiency()));
}

TEST_CASE("zones cover the contact without gaps and tell the stick fraction (T4.2, T4.3)",
          "[core][contact][identity]") {
  for_each_point([](const Motor& motor, const OperatingPoint& point) {
    const auto zones = motor.zones(point.speed);
    REQUIRE_FALSE(zones.empty());
    const double half = motor.contact().half_angle;
    double stuck = 0;
    double covered = 0;
    for (std::size_t i = 0; i < zones.size(); ++i) {
      CHECK(zones[i].from < zones[i].to);
      if (i > 0) CHECK(zones[i].from == zones[i - 1].to);
      if (i > 0) CHECK(zones[i].state != zones[i - 1].state);
      covered += zones[i].to - zones[i].from;
      if (zones[i].state == ZoneState::stick) stuck += zones[i].to - zones[i].from;
    }
    // Borders are roots near +-pi known to a few eps.
    CHECK(covered == Approx(2 * half).epsilon(1e-12));
    CHECK(point.stick_fraction == Approx(stuck / (2 * half)).margin(1e-12).epsilon(1e-12));
  });
}

TEST_CASE("a curve is its points", "[core][point][identity]") {
  const Motor motor(ring_motor());
  std::vector<double> speeds;
  for (int i = 0; i <= 120; ++i) speeds.push_back(motor.crest_speed() * (i - 20) / 80.0);
  const auto curve = torque_speed_curve(motor, speeds);
  REQUIRE(curve.size() == speeds.size());
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    CHECK(curve[i].speed == speeds[i]);
    // A neighbour's state may serve as starting guess, so equality holds to the accuracy of the state.
    CHECK(std::abs(curve[i].torque - motor.operating_point(speeds[i]).torque) <=
          1e-12 * motor.holding_torque());
  }
}

TEST_CASE("the same question has the same answer to the bit", "[core][point][identity]") {
  const Motor motor(ring_motor());
  const Motor again(ring_motor());
  for (const double share : {0.0, 0.3, 0.7, 0.9, 1.2}) {
    const auto first = motor.operating_point(share * motor.crest_speed());
    motor.operating_point(0.5 * motor.crest_speed());
    const auto second = motor.operating_point(share * motor.crest_speed());
    const auto other = again.operating_point(share * motor.crest_speed());
    CHECK(first.torque == second.torque);
    CHECK(first.friction_power == second.friction_power);
    CHECK(first.torque == other.torque);
  }
}
