// SPDX-License-Identifier: Apache-2.0
// Studies of lives, and the wear block of motor files.
#include <twum/core/life.hpp>
#include <twum/core/metrics.hpp>
#include <twum/io/source.hpp>
#include <twum/motors/expression.hpp>
#include <twum/motors/motor_file.hpp>
#include <twum/studies/run_study.hpp>
#include <twum/studies/study_file.hpp>
#include <twum/studies/telling.hpp>

#include <catch2/catch.hpp>

#include "support/heat_motors.hpp"

#include <cmath>

using namespace twum;
using namespace twum::studies;
using namespace twum::test;

namespace {

MotorDesign worn_60() {
  MotorDesign design = warm_motor();
  design.thermal.reset();
  Wear& wear = design.wear.emplace();
  wear.specific_wear = 1e-15;
  wear.depth_limit = 100e-6;
  return design;
}

StudyResult lived(const LifeStudy& asked, const MotorDesign& design = worn_60()) {
  return run_study({.motor = {"motor", design}, .asked = asked});
}

const LifeResult& life_of(const StudyResult& result) { return std::get<LifeResult>(result.answer); }

std::string motor_with(const std::string& wear, const std::string& layer = "material: peek") {
  return "twum: 1\nmotor:\n  stator: {wavelengths: 9, contact_radius: 26.5 mm, contact_width: 4 "
         "mm, "
         "neutral_plane_distance: 3 mm, frequency: 40 kHz, amplitude: 1.6 um}\n  contact_layer: {" +
         layer + ", thickness: 0.3 mm}\n  friction: {kinetic: 0.2}\n  preload: 160 N\n" + wear;
}

std::string refusal(const std::string& text) {
  try {
    read_motor(Source("worn.yaml", text));
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a life study tells when a life ends and why", "[studies][life]") {
  MotorDesign design = worn_60();
  const StudyResult result = lived({.torque = 0.5}, design);
  REQUIRE(result.outcome == "done");
  const LifeResult::Member& motor = life_of(result).members.at(0);
  const Life expected = life(design, {Argument::torque, 0.5, 0});
  CHECK(motor.life.seconds == expected.seconds);
  CHECK(motor.limits.at(0).ended);
  REQUIRE(motor.points.size() == 51);
  // the way in 50 steps with three points each ends where the life ends
  CHECK(std::fabs(motor.points.back().wear.seconds / expected.seconds - 1) <= 1e-6);
  CHECK(motor.points.front().margins.at(0) == 1);
  CHECK(std::fabs(motor.points.back().margins.at(0)) <= 1e-12);
  CHECK(summary_text(result).find("has a life of") != std::string::npos);
  CHECK(summary_text(result).find("not valid for wear") != std::string::npos);
  // A start voltage ends it earlier.
  design.wear->until = {{{Metric::start_voltage}, -HUGE_VAL, 120, "start_voltage <= 120 V"}};
  const StudyResult limited = lived({.torque = 0.5}, design);
  CHECK(life_of(limited).members.at(0).limits.at(1).ended);
  CHECK(life_of(limited).members.at(0).life.seconds < expected.seconds);
  CHECK(summary_text(limited).find("start_voltage <= 120 V") != std::string::npos);
}

TEST_CASE("a family of lives tells the longest", "[studies][life]") {
  LifeStudy asked{.torque = 0.5, .points = 11};
  asked.family = CurveStudy::Family{Parameter::preload_spring, {0, 1e5, 3e5}};
  const StudyResult result = lived(asked);
  REQUIRE(life_of(result).members.size() == 3);
  for (const LifeResult::Member& one : life_of(result).members)
    CHECK(one.life.seconds ==
          life(with(worn_60(), Parameter::preload_spring, one.value), {Argument::torque, 0.5, 0})
              .seconds);
  CHECK(summary_text(result).find("has the longest life") != std::string::npos);
}

TEST_CASE("a motor without wear, or without a load, is refused with a sentence",
          "[studies][life]") {
  CHECK_THROWS_WITH(lived({.torque = 0.5}, driven_motor()), Catch::Contains("give 'wear'"));
  CHECK_THROWS_WITH(lived({}), Catch::Contains("nothing loads the motor"));
}

TEST_CASE("a motor that only rests does not wear, which is an answer", "[studies][life]") {
  MotorDesign design = worn_60();
  design.operation = {{{}, 60, {}}};
  const StudyResult result = lived({.points = 3}, design);
  CHECK(result.outcome == "done");
  CHECK(life_of(result).members.at(0).status == "does-not-wear");
  CHECK(summary_text(result).find("does not wear: nothing slips in its contact") !=
        std::string::npos);
}

TEST_CASE("a search for a long life leaves motors that violate a limit from the first hour",
          "[studies][life]") {
  MotorDesign design = worn_60();
  design.wear->preload_spring = 1e5;
  design.wear->until = {{{Metric::start_voltage}, -HUGE_VAL, 120, "start_voltage <= 120 V"}};
  design.preload = 190;  // start_voltage grows with the preload
  const MetricRequest asked{Metric::life_at, Argument::torque, 0.5};
  REQUIRE(evaluate(Motor(design), asked).value == 0);
  const MetricDerivative none = differentiate(Motor(design), asked);
  CHECK(none.smoothness == Smoothness::flat);
  CHECK(none.gradient[index_of(Parameter::preload)] == 0);
  DesignProblem problem;
  problem.vary(Parameter::preload, 150, 195).maximize("life_at(0.5 N.m)");
  OptimizeStudy study;
  study.variables = problem.variables, study.objective = problem.objectives.front();
  study.solver.starts = 1, study.solver.budget.evaluations = 60;
  const StudyResult result = run_study({.motor = {"motor", design}, .asked = study});
  const auto& best = std::get<OptimizeResult>(result.answer).best;
  CHECK(evaluate(Motor(with(design, Parameter::preload, best.design.front().value)), asked).value >
        1000 * 3600);
}

TEST_CASE("a life without end is no goal, and keeps a limit", "[studies][life]") {
  // a contact that never slips: what the motor does is to rest
  MotorDesign design = worn_60();
  design.operation = {{{}, 60, {}}};
  const auto searched = [&](DesignProblem problem) {
    problem.vary(Parameter::preload, 150, 190);
    OptimizeStudy asked;
    asked.variables = problem.variables, asked.objective = problem.objectives.front();
    asked.constraints = problem.limits;
    return run_study({.motor = {"motor", design}, .asked = asked});
  };
  CHECK_THROWS_WITH(searched(DesignProblem{}.maximize("life")),
                    Catch::Contains("life has no end") && Catch::Contains("give it as a limit"));
  CHECK(searched(DesignProblem{}.maximize("holding_torque").limit("life >= 1000 h")).outcome ==
        "optimal");
}

TEST_CASE("wear is read from a motor file and written again", "[studies][life]") {
  const MotorFile motor = read_motor(Source(
      "worn.yaml",
      motor_with(
          "  wear: {specific_wear: 1e-6 mm^3/(N.m), depth_limit: 100 um, preload_spring: 100 "
          "N/mm, until: [\"stall_torque >= 0.5 N.m\", \"speed_at(0.3 N.m) >= 60 rpm\"]}\n")));
  REQUIRE(motor.design.wear);
  const Wear& wear = *motor.design.wear;
  CHECK(std::fabs(*wear.specific_wear / 1e-15 - 1) <= 1e-12);  // a conversion of units
  CHECK(wear.preload_spring == 1e5);
  REQUIRE(wear.until.size() == 2);
  CHECK(wear.until[0].request == MetricRequest{Metric::stall_torque});
  CHECK(wear.until[0].lower == 0.5);
  const MotorFile again = read_motor(Source("again.yaml", motor_text(motor)));
  CHECK(again.design.wear == motor.design.wear);
}

TEST_CASE("a lining of the catalogue has its own specific wear", "[studies][life]") {
  const MotorFile motor =
      read_motor(Source("worn.yaml", motor_with("  wear: {depth_limit: 50 um}\n")));
  CHECK(std::fabs(*motor.design.wear->specific_wear / 6.5e-14 - 1) <=
        1e-12);  // materials/peek.yaml
  // and a motor that does not wear has none
  CHECK(!read_motor(Source("new.yaml", motor_with(""))).design.wear);
}

TEST_CASE("what is wrong with a wear block is said where it stands", "[studies][life]") {
  const std::string own =
      "youngs_modulus: 3 GPa, poisson_ratio: 0.35, density: 1800 kg/m^3, "
      "loss_factor: 0.05";
  CHECK_THAT(refusal(motor_with("  wear: {depth_limit: 50 um}\n", own)),
             Catch::Contains("specific_wear") && Catch::Contains("missing"));
  CHECK_THAT(refusal(motor_with("  wear: {specific_wear: 1e-6 mm^3/(N.m)}\n")),
             Catch::Contains("depth_limit"));
  CHECK_THAT(refusal(motor_with("  wear: {depth_limit: 50 um, specific_wear: 0 mm^3/(N.m)}\n")),
             Catch::Contains("more than 0"));
  CHECK_THAT(refusal(motor_with("  wear: {until: [\"life_at(0.3 N.m) >= 10 h\"]}\n")),
             Catch::Contains("is about the life itself"));
  CHECK_THAT(refusal(motor_with("  wear: {until: [\"stall_torque / 2 >= 1 N.m\"]}\n")),
             Catch::Contains("is no limit of one metric"));
}

TEST_CASE("worn() asks for a metric at the end of a life", "[studies][life]") {
  const MetricExpression own = parse_metric("worn(speed_at(0.5 N.m))");
  REQUIRE(own.request() != nullptr);
  CHECK(own.request()->worn_at == LoadPoint{Argument::none, 0, 0});
  const MetricExpression named = parse_metric("worn(stall_torque, 0.5 N.m)");
  CHECK(named.request()->worn_at == LoadPoint{Argument::torque, 0.5, 0});
  CHECK_THROWS_WITH(parse_metric("worn(life_at(0.5 N.m))"),
                    Catch::Contains("is no metric of a worn motor"));
}
