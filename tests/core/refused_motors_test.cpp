// SPDX-License-Identifier: Apache-2.0
#include "support/test_motors.hpp"

#include <catch2/catch.hpp>

#include <twum/base/error.hpp>
#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>
#include <twum/core/motor_design.hpp>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

// Motors and speeds that cannot be are refused with what is wrong.

using namespace twum;
using namespace twum::test;

TEST_CASE("a speed at or below the negative wave speed is refused", "[core][edge][error]") {
  const Motor motor(ring_motor());
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double speed :
       {-motor.wave_speed(), -1.01 * motor.wave_speed(), -infinity, infinity, std::nan("")}) {
    CAPTURE(speed);
    CHECK_THROWS_AS(motor.operating_point(speed), InputError);
    CHECK_THROWS_AS(motor.zones(speed), InputError);
  }
  try {
    motor.operating_point(-2 * motor.wave_speed());
    FAIL("answered");
  } catch (const InputError& error) {
    // "... must be more than X rad/s (Y rpm), but is ...": six digits of each.
    std::vector<double> numbers;
    std::string text = error.what();
    for (std::size_t at = text.find_first_of("-0123456789"); at != std::string::npos;
         at = text.find_first_of("-0123456789")) {
      std::size_t used = 0;
      numbers.push_back(std::stod(text.substr(at), &used));
      text = text.substr(at + used);
    }
    REQUIRE(numbers.size() == 4);
    const double wave = -motor.wave_speed(), rpm = 30 / 3.14159265358979324;
    CHECK(numbers[0] == Approx(wave).epsilon(1e-5));
    CHECK(numbers[1] == Approx(wave * rpm).epsilon(1e-5));
    CHECK(numbers[2] == Approx(2 * wave).epsilon(1e-5));
    CHECK(numbers[3] == Approx(2 * wave * rpm).epsilon(1e-5));
  }
  const MetricValue value =
      evaluate(motor, {Metric::torque_at, Argument::speed, -1.01 * motor.wave_speed()});
  CHECK(value.status == MetricStatus::out_of_range);
  CHECK(std::isnan(value.value));
}

TEST_CASE("a design that cannot be is refused with every complaint", "[core][edge][error]") {
  MotorDesign design = ring_motor();
  design.preload = -1;
  design.layer.youngs_modulus = 0;
  design.friction.threshold = 0.1;  // below kinetic
  try {
    Motor{design};
    FAIL("not refused");
  } catch (const InputError& error) {
    const std::string text = error.what();
    CAPTURE(text);
    CHECK(text.find("preload") != std::string::npos);
    CHECK(text.find("youngs_modulus") != std::string::npos);
    CHECK(text.find("static") != std::string::npos);
  }
}

TEST_CASE("numbers that are not finite are refused in every parameter", "[core][edge][error]") {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    for (double MotorDesign::*field : {&MotorDesign::preload}) {
      MotorDesign design = ring_motor();
      design.*field = bad;
      CHECK_THROWS_AS(Motor(design), InputError);
    }
    MotorDesign design = ring_motor();
    design.layer.given_inertia = bad;
    CHECK_THROWS_AS(Motor(design), InputError);
    design = ring_motor();
    design.stator.frequency = bad;
    CHECK_THROWS_AS(Motor(design), InputError);
  }
}
