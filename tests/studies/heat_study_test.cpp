// SPDX-License-Identifier: Apache-2.0
// Studies of temperatures, and the operation in motor files.
#include <twum/core/metrics.hpp>
#include <twum/core/steady_heat.hpp>
#include <twum/io/source.hpp>
#include <twum/motors/motor_file.hpp>
#include <twum/studies/run_study.hpp>
#include <twum/studies/study_file.hpp>
#include <twum/studies/telling.hpp>

#include <catch2/catch.hpp>

#include "support/heat_motors.hpp"
#include "support/motor_files.hpp"

#include <cmath>

using namespace twum;
using namespace twum::studies;
using namespace twum::test;

namespace {

MotorDesign limited_motor() {
  MotorDesign design = with_table(warm_motor());
  design.thermal->stator.temperature_limit = kZero + 45;
  design.thermal->housing.temperature_limit = kZero + 70;
  return design;
}

StudyResult heated(const HeatStudy& asked, const MotorDesign& design = limited_motor()) {
  return run_study({.motor = {"motor", design}, .asked = asked});
}

const HeatResult& heat_of(const StudyResult& result) { return std::get<HeatResult>(result.answer); }

MotorDesign with_operation(MotorDesign design) {
  design.operation = {{LoadPoint{Argument::torque, 0.8, 0}, 120, {}}, {{}, 60, {}}};
  return design;
}

std::string told(const StudyResult& result) { return summary_text(result); }

}  // namespace

TEST_CASE("a heat study tells the steady state, its on-time and its warm-up", "[studies][heat]") {
  const MotorDesign design = limited_motor();
  const StudyResult result = heated({.torque = 0.5}, design);
  REQUIRE(result.outcome == "done");
  const HeatResult::Member& motor = heat_of(result).members.at(0);
  const SteadyHeat steady = steady_heat(design, heat_load(0.5));
  CHECK(motor.steady->temperatures.stator == steady.temperatures.stator);
  CHECK(motor.steady->on_time ==
        evaluate(Motor(design), {Metric::on_time_at, Argument::torque, 0.5}).value);
  CHECK(motor.steady->duty_limit_status == "undefined");  // there is no operation
  CHECK(!motor.cycle);
  // one stable state, which the balance finds, too
  REQUIRE(motor.steady->states.size() == 1);
  CHECK(motor.steady->states[0].stable);
  CHECK(std::fabs(motor.steady->states[0].temperatures.stator - steady.temperatures.stator) <=
        1e-6);
  // five slow time constants leave exp(-5) of the rise
  REQUIRE(motor.warm_up.size() == 101);
  CHECK(motor.warm_up.front().temperatures.stator == design.thermal->ambient);
  const double rise = steady.temperatures.stator - design.thermal->ambient;
  CHECK(std::fabs(motor.warm_up.back().temperatures.stator - steady.temperatures.stator) <=
        0.02 * rise);
  CHECK(told(result).find("from cold it may run for") != std::string::npos);
  CHECK(told(result).find("too hot") != std::string::npos);
}

TEST_CASE("the heat on the ways to the ambient is that of all losses",
          "[studies][heat][identity]") {
  const StudyResult result = heated({.torque = 0.5});
  const HeatResult::Member& motor = heat_of(result).members.at(0);
  const PartTemperatures& t = motor.steady->temperatures;
  const HeatNetwork& n = motor.network;
  const double out = n.stator_ambient * (t.stator - motor.ambient) +
                     n.rotor_ambient * (t.rotor - motor.ambient) +
                     n.housing_ambient * (t.housing - motor.ambient);
  // Newton's method ends at 1e-9 K
  CHECK(std::fabs(out - motor.steady->losses.sum()) <= 1e-8);
}

TEST_CASE("a heat study tells the cycle of the operation", "[studies][heat]") {
  const MotorDesign design = with_operation(limited_motor());
  const StudyResult result = heated({}, design);
  REQUIRE(result.outcome == "done");
  const HeatResult::Member& motor = heat_of(result).members.at(0);
  CHECK(!motor.steady);
  REQUIRE(motor.cycle);
  CHECK(motor.cycle->found.peak.stator == load_cycle(design, design.operation).peak.stator);
  CHECK(motor.cycle->found.course.size() == 101);
  CHECK(told(result).find("Over its operation") != std::string::npos);
}

TEST_CASE("a family of heat studies has a motor for each value", "[studies][heat]") {
  HeatStudy asked{.torque = 0.3};
  asked.family = CurveStudy::Family{Parameter::voltage, {105, 120}};
  const StudyResult result = heated(asked);
  const HeatResult& heat = heat_of(result);
  REQUIRE(heat.members.size() == 2);
  for (const HeatResult::Member& one : heat.members)
    CHECK(one.steady->temperatures.stator ==
          steady_heat(with(limited_motor(), Parameter::voltage, one.value), heat_load(0.3))
              .temperatures.stator);
  CHECK(heat.members[0].steady->temperatures.stator < heat.members[1].steady->temperatures.stator);
}

TEST_CASE("a load that is lost is told with its time", "[studies][heat]") {
  // friction fades: beyond 0.7739 N m the load is lost after a time
  const StudyResult result = heated({.torque = 0.82}, fading_motor());
  const HeatResult::Member& motor = heat_of(result).members.at(0);
  CHECK(motor.steady->status == "no-steady-temperature");
  CHECK(motor.steady->lost_after > 600);
  CHECK(result.outcome == "failed");
  CHECK(told(result).find("loses its load") != std::string::npos);
}

TEST_CASE("bistable motors are told with every state", "[studies][heat]") {
  // of the reference tables: stable at 77.6 degC, unstable at 83.9 degC
  const StudyResult result = heated({.torque = 0.77}, fading_motor());
  const auto& states = heat_of(result).members.at(0).steady->states;
  REQUIRE(states.size() == 2);
  CHECK(states[0].stable);
  CHECK(!states[1].stable);
  CHECK(std::fabs(states[0].temperatures.stator - kZero - 77.6) <= 0.5);
  CHECK(std::fabs(states[1].temperatures.stator - kZero - 83.9) <= 0.5);
}

TEST_CASE("a motor without heat, or without a load, is refused with a sentence",
          "[studies][heat]") {
  CHECK_THROWS_WITH(heated({.torque = 0.5}, driven_motor()), Catch::Contains("give 'thermal'"));
  CHECK_THROWS_WITH(heated({}), Catch::Contains("nothing loads the motor"));
}

TEST_CASE("a node whose torque the motor does not carry is refused", "[studies][heat]") {
  MotorDesign design = warm_motor();
  design.thermal = Thermal{};
  design.thermal->one_node = OneNode{40, 50, 660};
  CHECK_THROWS_WITH(heated({.torque = 0.5}, design),
                    Catch::Contains("does not carry the torque of thermal.one_node, 50 N.m"));
}

TEST_CASE("an operation is read from a motor file and written again", "[studies][heat]") {
  MotorFile motor{"motor", with_operation(limited_motor())};
  motor.design.operation.push_back({LoadPoint{Argument::both, 6, 0.25}, 20, 90});
  motor.design.operation.push_back({LoadPoint{Argument::speed, 9, 0}, 30, {}});
  const std::string text = motor_text(motor);
  const MotorFile again = read_motor(Source("again.yaml", text));
  CHECK(again.design.operation == motor.design.operation);
  CHECK(text.find("idle") != std::string::npos);
}
