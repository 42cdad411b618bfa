// SPDX-License-Identifier: Apache-2.0
// Heat in motor files, expressions and limits.
#include <catch2/catch.hpp>

#include <twum/core/steady_heat.hpp>
#include <twum/io/diagnostics.hpp>
#include <twum/io/units.hpp>
#include <twum/io/value_error.hpp>
#include <twum/motors/expression.hpp>
#include <twum/motors/motor_file.hpp>
#include <twum/motors/motor_limit.hpp>

#include <cmath>
#include <string>

using namespace twum;
using namespace twum::studies;
using Catch::Matchers::Contains;

namespace {

const MotorDesign& warm_motor() {
  static const MotorDesign design =
      read_motor_file(TWUM_SOURCE_DIR "/examples/motors/warm-60.yaml").design;
  return design;
}

std::string refusal_of_limit(const char* text) {
  try {
    parse_limit(text);
  } catch (const ValueError& error) {
    return error.what();
  }
  return {};
}

std::string refusal_of_metric(const char* text) {
  try {
    parse_metric(text);
  } catch (const ValueError& error) {
    return error.what();
  }
  return {};
}

double value_of(const char* text) {
  const MetricExpression expression = parse_metric(text);
  return ExpressionEvaluator(std::span(&expression, 1)).evaluate(Motor(warm_motor())).front().value;
}

}  // namespace

TEST_CASE("a motor file gives the ways of its heat, temperatures in degC", "[studies][heat]") {
  REQUIRE(warm_motor().thermal.has_value());
  const Thermal& t = *warm_motor().thermal;
  CHECK(t.ambient == 20 + 273.15);
  CHECK(*t.stator.temperature_limit == 80 + 273.15);
  CHECK(*t.contact_temperature_limit == 120 + 273.15);
  CHECK(*t.housing.heat_capacity == 130);
  CHECK(*t.conductances.lining == 0.333);
  CHECK(std::fabs(*t.drift.resonance_frequency + 220e-6) <= 1e-18);  // a rounding
  CHECK(std::fabs(*t.drift.quality_factor + 3e-3) <= 1e-17);
  CHECK_FALSE(t.reference.has_value());
  // what is written reads as the same motor
  const MotorFile again = read_motor(Source("again.yaml", motor_text({"warm-60", warm_motor()})));
  CHECK(again.design == warm_motor());
}

TEST_CASE("degC is an absolute temperature and nothing else", "[studies][heat][units]") {
  CHECK(parse_quantity("20 degC", {"K", "20 degC", true}) == 293.15);
  CHECK(parse_quantity("-10.5 \xC2\xB0\x43", {"K", "20 degC", true}) == -10.5 + 273.15);
  CHECK(parse_quantity("300 K", {"K", "20 degC", true}) == 300);
  CHECK_THROWS_WITH(parse_quantity("20 degC", {"m", "1 mm"}),
                    Contains("'20 degC' is a temperature"));
  CHECK(parse_unit("degC", {"K", "20 degC", true}).read("20") == 293.15);
  CHECK(std::fabs(parse_quantity("5 ppm", {"1", "1"}) - 5e-6) <= 1e-21);
}

TEST_CASE("a limit compares degC with a temperature alone", "[studies][heat]") {
  const MotorLimit limit = parse_limit("stator_temperature_at(0.5 N.m) <= 80 degC");
  CHECK(limit.upper == 353.15);
  CHECK(limit.text == "stator_temperature_at(0.5 N.m) <= 80 degC");
  const MotorLimit both = parse_limit("-10 degC <= start_temperature <= 5 degC");
  CHECK(both.lower == 263.15);
  CHECK(both.upper == 278.15);
  CHECK(parse_limit("ambient_temperature >= 0 degC").lower == 273.15);
  CHECK(parse_limit("temperature_margin_at(0.5 N.m) >= 5 K").lower == 5);
  CHECK_THAT(refusal_of_limit("temperature_margin_at(0.5 N.m) >= 5 degC"),
             Contains("'5 degC' is an absolute temperature") && Contains("in K"));
  CHECK_THAT(refusal_of_limit("stator_temperature_at(0.5 N.m) - ambient_temperature <= 40 degC"),
             Contains("is an absolute temperature"));
  CHECK_THAT(refusal_of_limit("stator_temperature_at(0.5 N.m) - 20 degC <= 40 K"),
             Contains("is an absolute temperature"));
}

TEST_CASE("warm() asks for a metric at the temperatures of a point", "[studies][heat]") {
  const MetricExpression own = parse_metric("warm(speed_at(0.5 N.m))");
  REQUIRE(own.request() != nullptr);
  CHECK(own.request()->warm_at == LoadPoint{Argument::torque, 0.5});
  CHECK(own.unit() == "rad/s");
  const MetricExpression named = parse_metric("warm(stall_torque, 0.5 N.m)");
  CHECK(named.request()->argument == Argument::none);
  CHECK(named.request()->warm_at == LoadPoint{Argument::torque, 0.5});
  const MetricExpression held = parse_metric("warm(electrical_power_at(0.5 N.m, 10 rad/s))");
  CHECK(held.request()->warm_at == LoadPoint{Argument::both, 10, 0.5});
  CHECK(parse_metric("warm(stall_torque, 0.5 N.m, 10 rad/s)").request()->warm_at ==
        LoadPoint{Argument::both, 10, 0.5});
  CHECK(parse_metric("warm(stall_torque)").request()->warm_at == LoadPoint{Argument::none, 0, 0});
  CHECK_THAT(refusal_of_metric("warm(preload, 0.5 N.m)"), Contains("is no metric of the motor"));
  CHECK_THAT(refusal_of_metric("warm(stator_temperature_at(0.5 N.m))"),
             Contains("is no metric of the motor"));
  CHECK_THAT(refusal_of_metric("warm"), Contains("needs a metric in parentheses"));
  CHECK_THAT(refusal_of_metric("warm(speed_at(0.5 N))"), Contains("is a force"));

  // the motor whose parameters are those of its temperatures, by hand
  const SteadyHeat heat = steady_heat(warm_motor(), {Argument::torque, 0.5});
  MotorDesign by_hand = warm_motor();
  by_hand.thermal.reset();
  const double s = heat.temperatures.stator - 293.15, c = heat.temperatures.contact - 293.15,
               l = heat.temperatures.lining - 293.15;
  *by_hand.stator.resonance_frequency *= 1 - 220e-6 * s;
  *by_hand.stator.quality_factor *= 1 - 3e-3 * s;
  by_hand.stator.blocked_capacitance *= 1 + 4e-3 * s;
  by_hand.stator.loss_tangent *= 1 + 5e-3 * s;
  by_hand.layer.youngs_modulus *= 1 - 3e-3 * l;
  by_hand.friction.kinetic *= 1 - 1e-3 * c;
  by_hand.friction.threshold *= 1 - 1e-3 * c;
  const double speed = evaluate(Motor(by_hand), {Metric::speed_at, Argument::torque, 0.5}).value;
  // temperatures are settled to 1e-11 K, by which the speed moves by a part in a thousand each
  CHECK(std::fabs(value_of("warm(speed_at(0.5 N.m))") - speed) <= 1e-10 * speed);
  CHECK(value_of("warm(speed_at(0.5 N.m)) / speed_at(0.5 N.m)") < 0.9);
}
