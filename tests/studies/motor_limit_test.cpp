// SPDX-License-Identifier: Apache-2.0
#include <twum/io/value_error.hpp>
#include <twum/motors/motor_limit.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

using namespace twum;
using namespace twum::studies;

namespace {

constexpr double kRpm = 2 * std::numbers::pi / 60;

std::string complaint(const char* text) {
  try {
    parse_limit(text);
    return "";
  } catch (const ValueError& error) {
    return std::to_string(error.position()) + ": " + error.what();
  }
}

}  // namespace

TEST_CASE("a constraint limits a metric or a parameter in its own unit", "[studies][metrics]") {
  const MotorLimit wear = parse_limit(" wear_intensity_at(80 rpm) <= 5 kW/m^2 ");
  CHECK(wear.upper == 5000);
  CHECK(std::isinf(wear.lower));
  CHECK(wear.text == "wear_intensity_at(80 rpm) <= 5 kW/m^2");
  CHECK(parse_limit("preload>=60 N").lower == 60);
  CHECK(parse_limit("60 N <= preload").lower == 60);
  CHECK(parse_limit("contact_ratio <= 0.3").upper == 0.3);
  CHECK(parse_limit("max_pressure <= 2 * 5 MPa").upper == 10e6);
  CHECK(parse_limit("squeal_rate_at(20 rpm) <= 5 1/s").upper == 5);
  CHECK(parse_limit("squeal_rate_at(20 rpm) <= 5 1/s / 2").upper == 2.5);
}

TEST_CASE("a limit may depend on the motor: then left minus right is compared with zero",
          "[studies][metrics]") {
  const MotorLimit thin = parse_limit("thickness <= 0.1 * 2 * contact_half_length");
  CHECK(thin.metric.text == "thickness - 0.1 * 2 * contact_half_length");
  CHECK(thin.upper == 0);
  REQUIRE(thin.sides.size() == 2);
  CHECK(thin.sides[1].text == "0.1 * 2 * contact_half_length");
  const MotorLimit sum = parse_limit("h >= contact_half_length - 1 um");
  CHECK(sum.metric.text == "thickness - (contact_half_length - 1 um)");
  CHECK(sum.lower == 0);
}

TEST_CASE("a limit with two signs has two ends", "[studies][metrics]") {
  for (const char* text :
       {"145 rpm <= no_load_speed <= 155 rpm", "155 rpm >= no_load_speed >= 145 rpm"}) {
    const MotorLimit speed = parse_limit(text);
    CHECK(speed.metric.text == "no_load_speed");
    CHECK(speed.lower == 145 * kRpm);
    CHECK(speed.upper == 155 * kRpm);
    CHECK(speed.holds(150 * kRpm));
    CHECK(speed.excess(150 * kRpm) == 0);
    CHECK(speed.excess(144 * kRpm) == Approx(kRpm));
    CHECK(speed.excess(157 * kRpm) == Approx(2 * kRpm));
    CHECK(speed.at_least(146 * kRpm));
    CHECK_FALSE(speed.at_least(154 * kRpm));
    CHECK_FALSE(speed.holds(std::numeric_limits<double>::quiet_NaN()));
    CHECK(std::isnan(speed.excess(std::numeric_limits<double>::quiet_NaN())));
  }
}

TEST_CASE("an equality has a tolerance, which in % is relative", "[studies][metrics]") {
  for (const char* text :
       {"no_load_speed == 150 rpm +- 3 rpm", "no_load_speed == 150 rpm +- 2 %"}) {
    const MotorLimit speed = parse_limit(text);
    CHECK(speed.lower == Approx(147 * kRpm).epsilon(1e-15));  // sums of rounded numbers
    CHECK(speed.upper == Approx(153 * kRpm).epsilon(1e-15));
  }
  const MotorLimit share = parse_limit("contact_ratio == 0.5 +- 10 %");
  CHECK(share.lower == Approx(0.45).epsilon(1e-15));
  const MotorLimit tied = parse_limit("contact_width == 0.15 * contact_radius +- 10 um");
  CHECK(tied.metric.text == "contact_width - 0.15 * contact_radius");
  CHECK(tied.lower == -10e-6);
  CHECK(tied.upper == 10e-6);
}

TEST_CASE("a wrong constraint says where, what and what would be right",
          "[studies][metrics][error]") {
  CHECK(complaint("stall_torque") ==
        "12: 'stall_torque' limits nothing; expected a limit such as 'stall_torque >= 0.8 N.m'");
  CHECK(complaint("stall_torque > 1 N.m") ==
        "13: 'stall_torque > 1 N.m' compares with '>'; only '>=', '<=' and '== A +- B' are known");
  CHECK(complaint("stall_torque = 1 N.m") ==
        "13: 'stall_torque = 1 N.m' compares with '='; only '>=', '<=' and '== A +- B' are known");
  CHECK(complaint("stall_torque >= 1 N") ==
        "13: 'stall_torque' is a torque [N.m], but '1 N' is a force [N]; '>=' needs the same "
        "dimension on both sides");
  CHECK(complaint("stal_torque >= 1 N.m") ==
        "0: unknown metric 'stal_torque'; did you mean 'stall_torque'?");
  CHECK(complaint("stall_torque >=") ==
        "15: a part of the limit is empty; expected a metric or a quantity such as 'stall_torque' "
        "or '0.8 N.m'");
  CHECK(complaint(">= 1 N.m") ==
        "0: a part of the limit is empty; expected a metric or a quantity such as 'stall_torque' "
        "or '0.8 N.m'");
  CHECK(complaint("1 N >= 2 N") ==
        "4: '1 N >= 2 N' has no metric or parameter in it; expected a limit such as 'stall_torque "
        ">= 0.8 N.m'");
  CHECK(complaint("2 N <= preload <= 1 N") ==
        "15: '2 N <= preload <= 1 N' leaves no room; the smaller end must not exceed the larger "
        "one");
  CHECK(complaint("1 N <= preload >= 2 N") ==
        "15: '1 N <= preload >= 2 N' compares in two directions; expected one such as '145 rpm <= "
        "no_load_speed <= 155 rpm'");
  CHECK(complaint("contact_width <= contact_radius <= 1 m") ==
        "14: the ends of a limit with two signs are quantities, with a metric between them; write "
        "two limits instead");
  CHECK(complaint("no_load_speed == 150 rpm") ==
        "24: 'no_load_speed == 150 rpm' has no tolerance; an equality has a tolerance, such as "
        "'no_load_speed == 150 rpm +- 3 rpm'");
  CHECK(complaint("no_load_speed == 150 rpm +- 3 N") ==
        "27: '150 rpm' is an angular speed [rad/s], but '3 N' is a force [N]; '+-' needs the same "
        "dimension on both sides");
  CHECK(complaint("preload == 5 N +- 0 N") ==
        "17: a tolerance that is not positive; an equality has a tolerance, such as "
        "'no_load_speed == 150 rpm +- 3 rpm'");
}

TEST_CASE("a tolerance of a limit is a quantity of its dimension, zero or more",
          "[studies][metrics][error]") {
  const auto refused = [](std::string_view tolerance) -> std::string {
    try {
      with_tolerance(parse_limit("stall_torque >= 0.5 N.m"), tolerance);
    } catch (const ValueError& error) {
      return error.what();
    }
    return "accepted";
  };
  using Catch::Matchers::Contains;
  CHECK(refused("0 N.m") == "accepted");
  CHECK(with_tolerance(parse_limit("stall_torque >= 0.5 N.m"), "2 mN.m").tolerance == 2e-3);
  CHECK_THAT(refused("-1 N.m"), Contains("'-1 N.m' is negative"));
  CHECK_THAT(refused("0.1 * stall_torque"), Contains("depends on the motor"));
  CHECK_THAT(refused("1 rpm"), Contains("needs the same dimension"));
}
