// SPDX-License-Identifier: Apache-2.0
#include "search_support.hpp"

#include <twum/core/held_point.hpp>

#include <catch2/catch.hpp>

#include <algorithm>

using namespace twum;
using namespace twum::test;
using Catch::Matchers::WithinRel;

TEST_CASE("the motor for a duty has just the preload that carries it (C8.5)", "[studies][size]") {
  // The pressure rises with the preload; at 20 rpm the whole contact slips, and T = mu F_N r.
  const StudyFile file = study_of("elastic-layer", "",
                                  "{kind: size, variables: {preload: {min: 40 N, max: 300 N}}, "
                                  "duty: [{torque: 0.5 N.m, speed: 20 rpm}]}");
  const ElasticLayer exact{file.motor.design};
  const Search s(file);
  const double preload = 0.5 / exact.plateau_torque(1);
  CHECK(s.answer.outcome == "optimal");
  CHECK_THAT(value(s.optimum().best.design, "preload"), WithinRel(preload, 1e-7));
  // p(0) = (E A / h) (1 - cos phi) (T3.1)
  const double phi = exact.angle_of_preload(preload);
  CHECK_THAT(value(s.optimum().best.metrics, "max_pressure"),
             WithinRel(3e9 * 1.6e-6 / 0.3e-3 * (1 - std::cos(phi)), 1e-6));
  REQUIRE(s.optimum().best.constraints.size() == 1);
  CHECK(s.optimum().best.constraints[0].text == "torque_at(20 rpm) >= 0.5 N.m");
  CHECK(s.optimum().best.constraints[0].active);
}

TEST_CASE(
    "with a drive that follows the least preload is what friction takes, with its reserve (C8.5, "
    "Y5.1)",
    "[studies][size][held]") {
  // At 20 rpm an amplitude below that of the motor lets the whole contact slip.
  const StudyFile file =
      study_of("elastic-layer", "",
               "{kind: size, variables: {preload: {min: 40 N, max: 300 N}}, drive: follows, "
               "prefer: preload, "
               "duty: [{torque: 0.5 N.m, speed: 20 rpm}, {torque: 0.2 N.m, speed: 40 rpm}]}");
  const ElasticLayer exact{file.motor.design};
  const Search s(file);
  CHECK(s.answer.outcome == "optimal");
  CHECK_THAT(value(s.optimum().best.design, "preload"),
             WithinRel(0.5 / exact.plateau_torque(1) / (1 - 1e-4), 1e-7));
  // Two reserves for each point, the first one of which binds.
  REQUIRE(s.optimum().best.constraints.size() == 4);
  for (const LimitState& limit : s.optimum().best.constraints) CHECK(limit.implied);
  CHECK(s.optimum().best.constraints[0].text == "torque_reserve_at(0.5 N.m, 20 rpm) >= 1e-04");
  CHECK(s.optimum().best.constraints[0].active);
}

TEST_CASE("with a drive that follows a limit on the pressure holds at every point of the duty",
          "[studies][size][held]") {
  const StudyFile file = study_of(
      "elastic-layer", "",
      "{kind: size, variables: {preload: {min: 40 N, max: 300 N}, thickness: {min: 0.2 mm, max: "
      "0.5 mm}}, "
      "drive: follows, duty: [{torque: 0.5 N.m, speed: 20 rpm}, {torque: 0.2 N.m, speed: 90 rpm}], "
      "limits: [max_pressure <= 9 MPa, layer_aspect <= 0.2]}");
  const Search s(file);
  std::vector<std::string> texts;
  for (const LimitState& limit : s.optimum().best.constraints) texts.push_back(limit.text);
  for (const char* text :
       {"max_pressure_at(0.5 N.m, 20 rpm) <= 9 MPa", "max_pressure_at(0.2 N.m, 90 rpm) <= 9 MPa",
        "layer_aspect_at(0.5 N.m, 20 rpm) <= 0.2", "layer_aspect_at(0.2 N.m, 90 rpm) <= 0.2"})
    CHECK(std::find(texts.begin(), texts.end(), text) != texts.end());
  CHECK(s.optimum().goal.metric ==
        "max(max_pressure_at(0.5 N.m, 20 rpm), max_pressure_at(0.2 N.m, 90 rpm))");
  // The answer tells each point of the duty.
  for (const char* text : {"amplitude_at(0.5 N.m, 20 rpm)", "pull_out_margin_at(0.2 N.m, 90 rpm)"})
    CHECK(value(s.optimum().best.metrics, text) > 0);
}

TEST_CASE("a duty that no drive can hold is told by the torque, and nothing of it can be loosened",
          "[studies][size][infeasible][held]") {
  const Search s(
      study_of("elastic-layer", "",
               "{kind: size, variables: {preload: {min: 40 N, max: 300 N}}, drive: follows, "
               "duty: [{torque: 5 N.m, speed: 20 rpm}]}"));
  CHECK(s.answer.outcome == "infeasible");
  REQUIRE(s.optimum().explanation.impossible.size() == 1);
  const ImpossibleState& told = s.optimum().explanation.impossible[0];
  CHECK(told.text == "torque_reserve_at(5 N.m, 20 rpm) >= 1e-04");
  const ElasticLayer exact{study_of("elastic-layer", "", "{kind: curve}").motor.design};
  CHECK_THAT(told.best, WithinRel(1 - 5 / exact.plateau_torque(300), 1e-6));  // (Y5.1)
  CHECK(s.optimum().explanation.limits.empty());
}

TEST_CASE("a duty at rest has no drive that follows, and says where it stands",
          "[studies][size][held]") {
  const auto duty = [](const char* drive) {
    return study_of(
        "elastic-layer", "",
        std::string("{kind: size, variables: {preload: {min: 40 N, max: 300 N}}, drive: ") + drive +
            ", duty: [{torque: 0.5 N.m, speed: 20 rpm}, {torque: 0.1 N.m, speed: 0 rpm}]}");
  };
  CHECK_NOTHROW(duty("fixed"));
  CHECK_THROWS_WITH(duty("follows"),
                    Catch::Contains("study.duty[1].speed: '0 rpm' together with 'drive: follows'"));
}

TEST_CASE(
    "a search beyond the end of the drive comes back to motors that hold the torque (Y5.2, Y5.3)",
    "[studies][optimize][held]") {
  // The start holds nothing at its 20 V.
  const StudyFile file =
      study_of("drive-60", "{voltage: 20 V}",
               "{kind: optimize, variables: {voltage: {min: 10 V, max: 150 V}}, minimize: voltage, "
               "constraints: ['electrical_power_at(0.4 N.m, 90 rpm) <= 40 W']}");
  const Search s(file);
  CHECK(s.answer.outcome == "optimal");
  MotorDesign design = file.motor.design;
  const double voltage = value(s.optimum().best.design, "voltage");
  CHECK_THAT(
      voltage,
      WithinRel((1 + 1e-4) * least_voltage_point(design, 0.4, 3 * 3.14159265358979).voltage, 1e-7));
  CHECK(held_point(with(design, Parameter::voltage, voltage), 0.4, 3 * 3.14159265358979).status ==
        HeldStatus::ok);
}

TEST_CASE("a start that cannot carry a load is no failure, and leads to one that can",
          "[studies][size]") {
  // 60 N carry 0.318 N.m at most.
  const StudyFile file = study_of("elastic-layer", "{preload: 60 N}",
                                  "{kind: optimize, variables: {preload: {min: 40 N, max: 300 N}}, "
                                  "minimize: preload, constraints: [speed_at(0.5 N.m) >= 120 rpm], "
                                  "solver: {starts: 1}}");
  const Search s(file);
  CHECK(s.answer.outcome == "optimal");
  const LimitState& limit = s.optimum().best.constraints.at(0);
  CHECK(limit.active);
  CHECK_THAT(limit.value, WithinRel(120 * 2 * 3.14159265358979 / 60, 1e-6));
  // The torque at that speed is the load: the two metrics are inverse to each other (T7.15).
  MotorDesign best =
      with(file.motor.design, Parameter::preload, value(s.optimum().best.design, "preload"));
  CHECK_THAT(Motor(best).operating_point(limit.value).torque, WithinRel(0.5, 1e-6));
  // The first row: infeasible, without a speed, but not a failure.
  const StoredRow first = s.rows().front();
  CHECK(first.values.at(0) == 60);
  CHECK(std::isnan(first.values.at(1)));
  CHECK(first.status == "ok");
}

TEST_CASE("where speed_at jumps, the load itself is the limit that binds", "[studies][size]") {
  // The plateau ends near 100 rpm: the least preload that carries 0.5 N.m does so up to there at once.
  const StudyFile file = study_of("elastic-layer", "",
                                  "{kind: optimize, variables: {preload: {min: 40 N, max: 300 N}}, "
                                  "minimize: preload, constraints: [speed_at(0.5 N.m) >= 50 rpm]}");
  const ElasticLayer exact{file.motor.design};
  const Search s(file);
  CHECK_THAT(value(s.optimum().best.design, "preload"),
             WithinRel(0.5 / exact.plateau_torque(1), 1e-6));
}

TEST_CASE("sizes with whole numbers of waves, whichever is best", "[studies][size]") {
  const StudyFile file = example_study("size-05Nm-100rpm.yaml");
  const Search s(file, 2);
  CHECK(s.answer.outcome == "optimal");
  const double n = value(s.optimum().best.design, "wavelengths");
  CHECK(n == std::round(n));
  const double best = value(s.optimum().best.metrics, "max_pressure");
  // Each number of waves as a study of its own.
  double least = HUGE_VAL;
  double of = 0;
  for (int waves = 5; waves <= 11; ++waves) {
    StudyFile fixed = file;
    for (DesignVariable& variable : std::get<SizeStudy>(fixed.asked).variables)
      if (variable.parameter == twum::Parameter::wavelengths) variable.min = variable.max = waves;
    const Search one(fixed, 2);
    if (one.answer.outcome != "optimal") continue;
    const double pressure = value(one.optimum().best.metrics, "max_pressure");
    if (pressure < least) of = waves;
    least = std::min(least, pressure);
  }
  CHECK(n == of);
  // Two searches, each within its tolerance of 1e-6 of the optimum.
  CHECK(best == Approx(least).epsilon(2e-6));
}
