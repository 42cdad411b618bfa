// SPDX-License-Identifier: Apache-2.0
#include "studies/statistics/study_text.hpp"

#include <twum/studies/tolerance.hpp>

#include <catch2/catch.hpp>

#include <string>
#include <variant>

// Quantiles of the standard normal, uniform and triangular distributions are textbook numbers: a value is the centre and
// a known number of spreads. 1e-12 is what rounding leaves of a quantile.
namespace {

using namespace twum;
using namespace twum::studies;
using Form = Tolerance::Shape;
using twum::test::run;

constexpr double kOneSd = 0.8413447460685429;  // probability below the mean and one deviation

Tolerance of(Parameter parameter, Form form) {
  Tolerance one;
  one.parameter = parameter;
  one.shape = form;
  return one;
}

double spread_about(const Tolerance& one, double value) {
  return one.distribution(value).quantile(kOneSd) - one.distribution(value).quantile(0.5);
}

}  // namespace

TEST_CASE("a relative spread follows the design, an absolute one does not",
          "[studies][tolerance]") {
  Tolerance share = of(Parameter::preload, Form::normal);
  share.sd = Spread{0.03, true};
  Tolerance force = share;
  force.sd = Spread{6, false};
  for (const double preload : {95.0, 160.0}) {
    CHECK(share.distribution(preload).quantile(0.5) == Approx(preload).epsilon(1e-12));
    CHECK(spread_about(share, preload) == Approx(0.03 * preload).epsilon(1e-12));
    CHECK(spread_about(force, preload) == Approx(6).epsilon(1e-12));
  }
}

TEST_CASE("a given mean is what a relative spread is a share of", "[studies][tolerance]") {
  Tolerance friction = of(Parameter::kinetic_friction, Form::normal);
  friction.mean = 0.35;
  friction.sd = Spread{0.1, true};
  CHECK(friction.distribution(0.2).quantile(0.5) == Approx(0.35).epsilon(1e-12));
  CHECK(spread_about(friction, 0.2) == Approx(0.035).epsilon(1e-12));
}

TEST_CASE("a range and a triangle lie about the design", "[studies][tolerance]") {
  Tolerance range = of(Parameter::preload, Form::uniform);
  range.range = Spread{0.05, true};
  CHECK(range.distribution(200).quantile(0.25) == Approx(195).epsilon(1e-12));
  CHECK(range.distribution(200).quantile(0.75) == Approx(205).epsilon(1e-12));
  Tolerance triangle = of(Parameter::preload, Form::triangular);
  triangle.below = Spread{0.02, true};
  triangle.above = Spread{10, false};
  // From 196 over 200 to 210 N: 4 / 14 of the motors lie below the top, and a quarter of those below the middle.
  CHECK(triangle.distribution(200).quantile(4.0 / 14) == Approx(200).epsilon(1e-12));
  CHECK(triangle.distribution(200).quantile(1.0 / 14) == Approx(198).epsilon(1e-12));
}

TEST_CASE("waves keep equal shares about the design's number", "[studies][tolerance]") {
  Tolerance waves = of(Parameter::wavelengths, Form::uniform);
  waves.range = Spread{1, false};
  CHECK(waves.distribution(9).quantile(1.0 / 3) == Approx(8.5).epsilon(1e-12));
  CHECK(waves.distribution(9).quantile(2.0 / 3) == Approx(9.5).epsilon(1e-12));
}

// On its plateau the elastic motor has the stall torque mu F_N r, which follows the preload.
TEST_CASE("the same tolerances tell the yield of the motor at hand", "[studies][tolerance]") {
  const std::string study =
      "  kind: uncertainty\n"
      "  variables: {preload: 5 %}\n"
      "  samples: 400\n"
      "  metrics: [stall_torque]\n"
      "  limits: [stall_torque >= 0.5035 N.m]\n";
  const auto yield_at = [&](double preload) {
    StudyFile file = twum::test::elastic_study(study);
    file.motor.design = with(file.motor.design, Parameter::preload, preload);
    return std::get<UncertaintyResult>(run_study(file).answer).yield->value;
  };
  // 0.2 x 95 N x 26.5 mm is 0.5035 N.m: half of such motors. Five standard errors of a share of 400 are 0.125.
  CHECK(yield_at(95) == Approx(0.5).margin(0.125));
  CHECK(yield_at(160) == 1);
}

TEST_CASE("a mean that is not the motor's is told with both numbers", "[studies][tolerance]") {
  const StudyResult result =
      run("  kind: uncertainty\n"
          "  variables: {preload: {mean: 140 N, sd: 3 %}}\n"
          "  samples: 4\n"
          "  metrics: [stall_torque]\n");
  REQUIRE_FALSE(result.model_notes.empty());
  CHECK(result.model_notes.front().find("140 N") != std::string::npos);
  CHECK(result.model_notes.front().find("160 N") != std::string::npos);
}
