// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/metrics/expression.hpp>
#include <twum/studies/text/value_error.hpp>

#include <catch2/catch.hpp>

#include <array>
#include <numbers>

using namespace twum;
using namespace twum::studies;

namespace {

struct Bad {
  const char* text;
  std::size_t position;
  const char* message;
};

const Bad kBad[] = {
    {"", 0, "nothing; expected a metric such as 'stall_torque' or 'torque_at(100 rpm)'"},
    {"stal_torque", 0, "unknown metric 'stal_torque'; did you mean 'stall_torque'?"},
    {"preloda", 0, "unknown metric 'preloda'; did you mean 'preload'?"},
    {"beauty", 0,
     "unknown metric 'beauty'; 'twum metrics' lists the metrics, 'twum parameters' the parameters"},
    {"torque_at", 9, "'torque_at' needs a speed; expected one such as 'torque_at(100 rpm)'"},
    {"speed_at", 8, "'speed_at' needs a torque; expected one such as 'speed_at(0.5 N.m)'"},
    {"efficiency_at", 13,
     "'efficiency_at' needs a speed or a torque; expected one such as 'efficiency_at(100 rpm)'"},
    {"torque_at(0.5 N.m)", 14,
     "torque_at: '0.5 N.m' is a torque [N.m]; expected an angular speed [rad/s] such as '100 rpm'"},
    {"speed_at(100 rpm)", 13,
     "speed_at: '100 rpm' is an angular speed [rad/s]; expected a torque [N.m] such as '0.5 N.m'"},
    {"torque_at(100)", 13,
     "torque_at: '100' has no unit; expected an angular speed [rad/s] such as '100 rpm'"},
    {"torque_at()", 10, "torque_at: nothing; expected an angular speed [rad/s] such as '100 rpm'"},
    {"torque_at(100 rpm", 17, "'torque_at(100 rpm' has no ')'; close the parenthesis"},
    {"torque_at(100 rpm) + 1", 18, "' + 1' after the ')'; nothing may follow it"},
    {"stall_torque(100 rpm)", 12,
     "'stall_torque' takes nothing in parentheses; write it without them"},
    {"preload(100 rpm)", 7,
     "'preload' is a parameter and takes nothing in parentheses; write it without them"},
};

MetricRequest request(const char* text) { return std::get<MetricRequest>(parse_metric(text).what); }

}  // namespace

TEST_CASE("the unit of a point metric's argument tells speed from torque", "[studies][metrics]") {
  const MetricRequest at_speed = request(" efficiency_at( 60 rpm ) ");
  CHECK(at_speed.metric == Metric::efficiency_at);
  CHECK(at_speed.argument == Argument::speed);
  CHECK(at_speed.at == 60 * (2 * std::numbers::pi / 60));
  const MetricRequest at_torque = request("efficiency_at(500 mN.m)");
  CHECK(at_torque.argument == Argument::torque);
  CHECK(at_torque.at == 0.5);
  CHECK(request("stall_torque").argument == Argument::none);
}

TEST_CASE("a parameter may stand where a metric may", "[studies][metrics]") {
  CHECK(std::get<Parameter>(parse_metric("preload").what) == Parameter::preload);
  CHECK(std::get<Parameter>(parse_metric("E").what) == Parameter::youngs_modulus);
  CHECK(parse_metric("E").unit() == "Pa");
  CHECK(parse_metric("wear_intensity_at(80 rpm)").unit() == "W/m^2");
}

TEST_CASE("a wrong expression says where, what and what would be right",
          "[studies][metrics][error]") {
  for (const Bad& bad : kBad) {
    CAPTURE(bad.text);
    try {
      parse_metric(bad.text);
      FAIL("not refused");
    } catch (const ValueError& error) {
      CHECK(error.what() == std::string(bad.message));
      CHECK(error.position() == bad.position);
    }
  }
}

TEST_CASE("every metric of the table can be written and read", "[studies][metrics]") {
  for (const MetricInfo& row : metric_table()) {
    const std::string name(row.name);
    if (row.argument == Argument::none) {
      CHECK_NOTHROW(parse_metric(name));
    } else {
      if (row.argument != Argument::torque) CHECK_NOTHROW(parse_metric(name + "(1 rad/s)"));
      if (row.argument != Argument::speed) CHECK_NOTHROW(parse_metric(name + "(1 N.m)"));
    }
  }
}

TEST_CASE("a list keeps its order and refuses repetitions", "[studies][metrics]") {
  const auto list = parse_metric_list("stall_torque, torque_at(100 rpm) ,preload");
  REQUIRE(list.size() == 3);
  CHECK(list[1].text == "torque_at(100 rpm)");
  CHECK_THROWS_WITH(parse_metric_list("stall_torque, stall_torque"),
                    "'stall_torque' is there twice; leave one of them out");
  CHECK_THROWS_AS(parse_metric_list("stall_torque,"), ValueError);
  try {
    parse_metric_list("stall_torque, torque_at(1 N)");
    FAIL("not refused");
  } catch (const ValueError& error) {
    CHECK(error.position() == 26);  // of the unit, in the whole list
  }
}

TEST_CASE("an evaluator gives metrics and parameters in the order asked", "[studies][metrics]") {
  const auto list = parse_metric_list("preload, holding_torque, h");
  const Motor motor{MotorDesign{}};
  std::array<MetricValue, 3> values{};
  ExpressionEvaluator(list).evaluate(motor, values);
  CHECK(values[0].value == 160);
  CHECK(values[1].value == motor.holding_torque());
  CHECK(values[2].value == 0.3e-3);
}
