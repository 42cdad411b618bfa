// SPDX-License-Identifier: Apache-2.0
#include "search_support.hpp"

#include <catch2/catch.hpp>

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
