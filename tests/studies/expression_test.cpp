// SPDX-License-Identifier: Apache-2.0
#include <twum/io/value_error.hpp>
#include <twum/motors/expression.hpp>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

using namespace twum;
using namespace twum::studies;

namespace {

struct Bad {
  const char* text;
  std::size_t position;
  const char* message;
};

const Bad kBad[] = {
    {"", 0, "empty; expected a metric such as 'stall_torque' or 'torque_at(100 rpm)'"},
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
    {"torque_at()", 10, "torque_at: empty; expected an angular speed [rad/s] such as '100 rpm'"},
    {"torque_at(100 rpm", 17, "'torque_at(100 rpm' has no ')'; close the parenthesis"},
    {"torque_at(100 rpm) + 1", 19,
     "'torque_at(100 rpm)' is a torque [N.m], but '1' is a number without unit; '+' needs the same "
     "dimension on both sides"},
    {"2 * h", 4,
     "'h' is a symbol, which an expression does not read; write 'thickness'; a unit is written "
     "without blanks, such as '5 kW/m^2'"},
    {"5 N", 0,
     "'5 N' has no metric or parameter in it; expected a metric such as 'stall_torque' or "
     "'torque_at(100 rpm)'"},
    {"2 * torque_at(5 N)", 16,
     "torque_at: '5 N' is a force [N]; expected an angular speed [rad/s] such as '100 rpm'"},
    {"stall_torque(100 rpm)", 12,
     "'stall_torque' takes nothing in parentheses; write it without parentheses"},
    {"drive_voltage_at(100 rpm)", 25,
     "'drive_voltage_at(100 rpm)' needs a torque and a speed; expected one such as "
     "'drive_voltage_at(0.5 N.m, 100 rpm)'"},
    {"torque_at(0.5 N.m, 100 rpm)", 19,
     "torque_at takes a speed alone; write 'torque_at(100 rpm)'"},
    {"efficiency_at(90 rpm, 100 rpm)", 22,
     "efficiency_at takes one torque and one speed, but both are speeds; write "
     "'efficiency_at(0.5 N.m, 100 rpm)'"},
    {"efficiency_at(90 rpm, 5 N)", 24,
     "efficiency_at: '5 N' is a force [N]; expected an angular speed [rad/s] such as '100 rpm' or "
     "a "
     "torque [N.m] such as '0.5 N.m'"},
    {"amplitude_at(0 rpm, 0.5 N.m)", 13,
     "amplitude_at: a drive holds a torque at a speed of more than 0 rpm; at rest friction holds "
     "it "
     "without a wave; give a speed such as '100 rpm'"},
    {"preload(100 rpm)", 7,
     "'preload' is a parameter and takes nothing in parentheses; write it without parentheses"},
};

MetricRequest request(const char* text) { return *parse_metric(text).request(); }

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

TEST_CASE("a torque and a speed stand in either order, and the drive follows",
          "[studies][metrics]") {
  const MetricRequest held{Metric::electrical_power_at, Argument::both, 10, 0.5};
  CHECK(request("electrical_power_at(0.5 N.m, 10 rad/s)") == held);
  CHECK(request("electrical_power_at( 10 rad/s ,500 mN.m )") == held);
  const auto two =
      parse_metric_list("drive_frequency_at(0.5 N.m, 100 rpm), drive_voltage_at(1 N.m, 10 rpm)");
  REQUIRE(two.size() == 2);
  CHECK(two[1].request()->torque == 1.0);
  CHECK(two[0].unit() == "Hz");
}

TEST_CASE("a parameter may stand where a metric may", "[studies][metrics]") {
  CHECK(*parse_metric("preload").parameter() == Parameter::preload);
  CHECK(*parse_metric("E").parameter() == Parameter::youngs_modulus);
  CHECK(parse_metric("E").text == "E");
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
    } else if (row.argument == Argument::both) {
      CHECK_NOTHROW(parse_metric(name + "(1 N.m, 1 rad/s)"));
    } else if (row.argument == Argument::angle) {
      CHECK_NOTHROW(parse_metric(name + "(90 deg)"));
      CHECK_THROWS_AS(parse_metric(name + "(0 rad)"), ValueError);
      CHECK_THROWS_AS(parse_metric(name + "(1 N.m)"), ValueError);
    } else if (row.argument == Argument::periods) {
      CHECK_NOTHROW(parse_metric(name + "(32)"));
      CHECK_THROWS_AS(parse_metric(name + "(0.5)"), ValueError);
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
                    "'stall_torque' is given twice; leave one of them out");
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

TEST_CASE("an expression has a canonical text, a unit, and each of its terms once",
          "[studies][metrics]") {
  const MetricExpression ratio = parse_metric(" thickness/(2*contact_half_length) ");
  CHECK(ratio.text == "thickness / (2 * contact_half_length)");
  CHECK(ratio.unit() == "1");
  CHECK(ratio.request() == nullptr);
  const MetricExpression square = parse_metric("peak_power * (peak_power)");
  CHECK(square.text == "peak_power * peak_power");
  CHECK(square.unit() == "W^2");
  CHECK(square.terms.size() == 1);
  CHECK(parse_metric("(preload)").text == "preload");
  CHECK(parse_metric("torque_at(100 rpm) * 100 rpm").unit() == "W");
}

TEST_CASE("an expression is worth what its terms are", "[studies][metrics]") {
  const Motor motor{MotorDesign{}};
  const auto value = [&](const char* text) {
    const std::vector<MetricExpression> list{parse_metric(text)};
    MetricValue answer;
    ExpressionEvaluator(list).evaluate(motor, std::span(&answer, 1));
    return answer;
  };
  const double half_length = evaluate(motor, {Metric::contact_half_length}).value;
  CHECK(value("thickness / (2 * contact_half_length)").value ==
        Approx(0.3e-3 / (2 * half_length)).epsilon(1e-15));
  CHECK(value("max(preload, 200 N) - 1 kN").value == -800);
  // What fails passes its own reason on; an operation without a value has no meaning.
  CHECK(value("2 * speed_at(100 N.m)").status == MetricStatus::unreachable);
  CHECK(value("max(preload * 1 m, torque_at(-1e6 rpm))").status == MetricStatus::out_of_range);
  CHECK(value("1 / (preload - 160 N)").status == MetricStatus::undefined);
  CHECK(std::isnan(value("1 / (preload - 160 N)").value));
}

TEST_CASE("gradients of expressions agree with differences of their values", "[studies][metrics]") {
  const std::vector<MetricExpression> list{
      parse_metric("thickness / (2 * contact_half_length)"),
      parse_metric("(peak_power - 5 W)^2"),
      parse_metric("sqrt(stall_torque * no_load_speed / peak_power) * log(preload / 1 N)"),
      parse_metric("shear_modulus / youngs_modulus + kinetic_friction^static_friction"),
      parse_metric("exp(-contact_ratio) * max(efficiency_at(100 rpm), 0.1)"),
      parse_metric("abs(torque_at(100 rpm) - 5 N.m) / min(preload, 1 kN)")};
  MotorDesign design;
  design.stator.modal_damping = 45;
  const ExpressionEvaluator evaluator(list);
  const auto derivatives = evaluator.differentiate(Motor(design), false);
  const auto values = [&](Parameter parameter, double x) {
    std::vector<MetricValue> answer(list.size());
    evaluator.evaluate(Motor(with(design, parameter, x)), answer);
    return answer;
  };
  for (const Parameter p : {Parameter::preload, Parameter::thickness, Parameter::youngs_modulus,
                            Parameter::amplitude, Parameter::kinetic_friction}) {
    const double x = get(design, p);
    const double step = 1e-4 * x;
    const auto right = values(p, x + step), left = values(p, x - step);
    const auto nearer_right = values(p, x + step / 2), nearer_left = values(p, x - step / 2);
    for (std::size_t i = 0; i < list.size(); ++i) {
      CAPTURE(list[i].text, info(p).name);
      const double wide = (right[i].value - left[i].value) / (2 * step);
      const double narrow = (nearer_right[i].value - nearer_left[i].value) / step;
      // Metrics are good to about 1e-12; over a step of 1e-4 that is 1e-8 of the value, and the truncation that
      // Richardson leaves is of fourth order in the step, 1e-16.
      const double size = std::fabs(derivatives[i].value.value) / x;
      CHECK(std::fabs(derivatives[i].gradient[index_of(p)] - (4 * narrow - wide) / 3) <=
            1e-7 * size);
    }
  }
}

TEST_CASE(
    "the gradient of an expression is as good as its worst term, and kinked where it branches",
    "[studies][metrics]") {
  const auto smoothness = [](const char* text) {
    const std::vector<MetricExpression> list{parse_metric(text)};
    return ExpressionEvaluator(list).differentiate(Motor(MotorDesign{}), false)[0].smoothness;
  };
  CHECK(smoothness("preload * 2") == Smoothness::smooth);
  CHECK(smoothness("abs(preload - 160 N)") == Smoothness::one_sided);
  CHECK(smoothness("abs(preload - 161 N)") == Smoothness::smooth);
  CHECK(smoothness("sqrt(preload - 160 N)") == Smoothness::undefined);
  CHECK(smoothness("1 / (preload - 160 N)") == Smoothness::undefined);
}
