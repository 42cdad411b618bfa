// SPDX-License-Identifier: Apache-2.0
// Studies of lives, and the wear block of motor files.
#include <twum/core/life.hpp>
#include <twum/core/metrics.hpp>
#include <twum/io/source.hpp>
#include <twum/motion/free_life.hpp>
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

TEST_CASE("a life study tells how each radius wears", "[studies][life]") {
  MotorDesign design = worn_60();
  design.stator.radial_slices = 8;
  const StudyResult driven = lived({.torque = 0.5, .points = 3}, design);
  const LifeResult::Member& motor = life_of(driven).members.at(0);
  REQUIRE(motor.profile_new.size() == 33);
  // The mean over the area is the rate of the whole track: trapezoids of 33 radii and means of 2000 phases leave a thousandth.
  double sum = 0, area = 0;
  for (std::size_t i = 0; i < motor.profile_new.size(); ++i) {
    const double weight = motor.profile_new[i].radius * (i == 0 || i == 32 ? 0.5 : 1);
    sum += weight * motor.profile_new[i].rate, area += weight;
  }
  CHECK(std::fabs(sum / area / motor.points.front().wear.rate - 1) <= 5e-3);
  CHECK(motor.stability == WearStability::uneven);
  CHECK(!motor.worn_in);
  CHECK(summary_text(driven).find("wears-unevenly") != std::string::npos);
  // With a given amplitude and most of the stall torque the track stays even, and has a state after run-in.
  design.stator.voltage.reset();
  design.stator.amplitude = 1.736e-6;
  const StudyResult given = lived({.torque = 0.95, .points = 3}, design);
  REQUIRE(life_of(given).members.at(0).worn_in);
  CHECK(summary_text(given).find("After run-in") != std::string::npos);
  CHECK(summary_text(given).find("wears-unevenly") == std::string::npos);
}

TEST_CASE("lining and spring are among the limits of a life", "[studies][life]") {
  MotorDesign design = worn_60();
  design.wear->preload_spring = 1e7;  // 170 N are gone after 17 um
  const StudyResult result = lived({.speed = 5.0, .points = 5}, design);
  const LifeResult::Member& motor = life_of(result).members.at(0);
  REQUIRE(motor.limits.size() == 3);
  CHECK(motor.limits[1].text == "preload >= 0 N");
  for (const LifeResult::Point& point : motor.points) {
    CHECK(point.margins[1] == point.wear.preload / design.preload);
    CHECK(point.margins[2] == point.wear.thickness / design.layer.thickness);
  }
}

TEST_CASE("the life that most motors reach has its name", "[studies][life][uncertainty]") {
  UncertaintyStudy asked;
  Tolerance scatter{Parameter::specific_wear, Tolerance::Shape::lognormal};
  scatter.sd = Spread{0.4, true};
  asked.variables = {scatter};
  asked.metrics = parse_metric_list("life_at(0.5 N.m)");
  asked.samples = 50;
  asked.quantiles = {0.1, 0.5};
  const StudyResult result = run_study({.motor = {"motor", worn_60()}, .asked = asked});
  const std::string text = summary_text(result);
  CHECK(text.find("90 % of the motors reach a life_at(0.5 N.m) of ") != std::string::npos);
  CHECK(text.find("(the life B10)") != std::string::npos);
  CHECK(text.find("B50") == std::string::npos);
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

TEST_CASE("a life with a free profile tells each radius", "[studies][life]") {
  MotorDesign design = worn_60();
  design.stator.radial_slices = 8;
  design.stator.voltage.reset();
  design.stator.amplitude = 1.736e-6;
  design.wear->profile = WearProfile::free;
  const StudyResult result = lived({.torque = 0.95, .points = 11}, design);
  REQUIRE(result.outcome == "done");
  const LifeResult::Member& motor = life_of(result).members.at(0);
  const motion::FreeLife right = motion::free_life(design, LoadPoint{Argument::torque, 0.95, 0});
  CHECK(motor.life.seconds == right.last.seconds);
  REQUIRE(motor.points.size() == 11);
  CHECK(motor.points.front().wear.seconds == 0);
  CHECK(motor.points.back().wear.seconds == right.last.seconds);
  CHECK(std::fabs(motor.points.back().margins.at(0)) <= 1e-9);  // of the deepest radius
  REQUIRE(motor.free);
  REQUIRE(motor.free->run_in);
  CHECK(motor.free->run_in->nodes.size() == 8);
  CHECK(motor.free->run_in->speed < motor.free->fresh.speed);
  CHECK(summary_text(result).find("After run-in all radii wear at one rate") != std::string::npos);
  // At light load one radius takes over.
  const StudyResult light = lived({.torque = 0.4, .points = 11}, design);
  CHECK(light.outcome == "done");
  CHECK(life_of(light).members.at(0).status == "wear-localizes");
  CHECK(summary_text(light).find("has no life") != std::string::npos);
  CHECK(summary_text(light).find("wears-unevenly") != std::string::npos);
  CHECK_THROWS_WITH(lived({.torque = 0.4, .speed = 5.0}, design),
                    Catch::Contains("wear.profile: even"));
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
  const std::string sliced = [] {
    std::string text = motor_with(
        "  wear: {specific_wear: 1e-6 mm^3/(N.m), depth_limit: 100 um, profile: free}\n");
    text.replace(text.find("amplitude: 1.6 um"), 17, "amplitude: 1.6 um, radial_slices: auto");
    return text;
  }();
  const MotorFile free = read_motor(Source("free.yaml", sliced));
  CHECK(free.design.wear->profile == WearProfile::free);
  CHECK(read_motor(Source("again.yaml", motor_text(free))).design.wear == free.design.wear);
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
  CHECK_THAT(refusal(motor_with("  wear: {depth_limit: 50 um, profile: free}\n")),
             Catch::Contains("radial_slices") && Catch::Contains("wear.profile: free"));
  CHECK_THAT(refusal(motor_with("  wear: {depth_limit: 50 um, profile: fre}\n")),
             Catch::Contains("did you mean 'free'"));
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
