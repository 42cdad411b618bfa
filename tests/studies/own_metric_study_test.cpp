// SPDX-License-Identifier: Apache-2.0
// Metrics that a program computes, in studies in memory and in what is told of them.
#include <twum/base/error.hpp>
#include <twum/core/motor.hpp>
#include <twum/io/value_error.hpp>
#include <twum/studies/report.hpp>
#include <twum/studies/run_study.hpp>

#include "support/scratch_folder.hpp"

#include <catch2/catch.hpp>

#include <string>

using namespace twum;
using namespace twum::studies;
using Catch::Contains;

namespace {

// What a track costs, a price for its area 2 pi r b and one for the motor [1].
OwnMetric cost() {
  constexpr double kTurn = 6.283185307179586, kPrice = 1e4;  // [1/m^2]
  OwnMetric own{.name = "cost"};
  own.value = [](const Motor& motor) {
    const Stator& s = motor.design().stator;
    return 2 + kPrice * kTurn * s.contact_radius * s.contact_width;
  };
  own.gradient = [](const Motor& motor) {
    const Stator& s = motor.design().stator;
    std::array<double, kParameterCount> gradient{};
    gradient[index_of(Parameter::contact_radius)] = kPrice * kTurn * s.contact_width;
    gradient[index_of(Parameter::contact_width)] = kPrice * kTurn * s.contact_radius;
    return gradient;
  };
  return own;
}

// The holding torque mu_0 F_N r (T7.8), which twum has as a metric too.
OwnMetric grip() {
  OwnMetric own{.name = "grip", .unit = "N.m"};
  own.value = [](const Motor& motor) { return motor.holding_torque(); };
  own.gradient = [](const Motor& motor) {
    return differentiate(motor, {Metric::holding_torque}).gradient;
  };
  return own;
}

StudyFile asking(Study study) { return {.motor = {"m", {}}, .asked = std::move(study)}; }

std::vector<DesignVariable> track() {
  return {{.parameter = Parameter::contact_radius, .min = 20e-3, .max = 30e-3},
          {.parameter = Parameter::contact_width, .min = 2e-3, .max = 6e-3},
          {.parameter = Parameter::preload, .min = 60, .max = 300}};
}

// The smallest cost of a motor with a grip.
OptimizeStudy cheap(const std::string& limit) {
  const KnownMetrics known({cost(), grip()});
  OptimizeStudy study;
  study.variables = track();
  study.objective = {parse_metric("cost"), false, {}};
  study.constraints = {parse_limit(limit), parse_limit("max_pressure <= 3 MPa")};
  return study;
}

const OptimizeResult& optimum(const StudyResult& result) {
  return std::get<OptimizeResult>(result.answer);
}

}  // namespace

TEST_CASE("an own metric that twum has too gives the same study", "[studies][own]") {
  const StudyResult own = run_study(asking(cheap("grip >= 600 N.mm")));
  const StudyResult ours = run_study(asking(cheap("holding_torque >= 600 N.mm")));
  CHECK(own.outcome == StudyOutcome::optimal);
  REQUIRE(optimum(own).best.design.size() == optimum(ours).best.design.size());
  for (std::size_t i = 0; i < optimum(own).best.design.size(); ++i)
    CHECK(optimum(own).best.design[i].value == optimum(ours).best.design[i].value);
  CHECK(optimum(own).best.constraints[0].multiplier ==
        optimum(ours).best.constraints[0].multiplier);
  CHECK(optimum(own).best.constraints[0].unit == "N.m");
}

TEST_CASE("rows and texts tell an own metric by its name and unit", "[studies][own]") {
  const StudyFile study = asking(cheap("grip >= 600 N.mm"));
  const StudyResult result = run_study(study);
  CHECK_THAT(results_csv(result), Contains("cost [1]") && Contains("grip [N.m]"));
  CHECK_THAT(summary_text(result), Contains("cost") && Contains("grip >= 600 N.mm"));
  CHECK_THAT(summary_text(result), !Contains("grip >= 600 N.mm, which the others imply"));
  CHECK_THAT(summary_markdown(result), Contains("grip ≥ 600 mN·m"));
  const std::string page = report_html(study, result);
  CHECK_THAT(page, Contains("minimize: cost") &&
                       Contains("# grip [N.m] is a metric of the program that asked."));
}

TEST_CASE("an own metric stands in a formula", "[studies][own]") {
  const KnownMetrics known({cost()});
  OptimizeStudy study = cheap("holding_torque >= 600 N.mm");
  study.objective = {parse_metric("peak_power / cost"), true, {}};
  const StudyResult result = run_study(asking(study));
  CHECK(result.outcome == StudyOutcome::optimal);
  CHECK(optimum(result).goal.unit == "W");
}

TEST_CASE("an own metric is a goal of a front, of a size, of a sweep and under tolerances",
          "[studies][own]") {
  const KnownMetrics known({cost(), grip()});
  ParetoStudy front;
  front.variables = track();
  front.objectives = {{parse_metric("cost"), false, {}}, {parse_metric("peak_power"), true, {}}};
  front.points = 3;
  const StudyFile asked = asking(front);
  const StudyResult trade = run_study(asked);
  CHECK(trade.outcome == StudyOutcome::optimal);
  CHECK_THAT(summary_text(trade), Contains("cost"));
  CHECK_THAT(report_html(asked, trade), Contains("minimize: cost"));

  SizeStudy size;
  size.variables = track();
  size.duty = {parse_limit("torque_at(60 rpm) >= 0.4 N.m")};
  size.prefer = {parse_metric("cost"), false, {}};
  CHECK(run_study(asking(size)).outcome == StudyOutcome::optimal);

  SweepStudy sweep;
  sweep.variables = {{.parameter = Parameter::contact_radius, .values = {20e-3, 25e-3}}};
  sweep.metrics = {expression_of(cost())};
  CHECK_THAT(results_csv(run_study(asking(sweep))), Contains("cost [1]"));

  UncertaintyStudy spread;
  spread.variables = {{.parameter = Parameter::preload, .sd = Spread{0.03, true}}};
  spread.metrics = {parse_metric("grip")};
  spread.limits = {parse_limit("grip >= 0.5 N.m")};
  spread.samples = 100;
  CHECK_THAT(summary_text(run_study(asking(spread))), Contains("grip"));
}

TEST_CASE("an own metric is a limit of a study with tolerances", "[studies][own][robust]") {
  const auto built = [](const std::string& limit) {
    const KnownMetrics known({grip()});
    OptimizeStudy study;
    study.variables = {{.parameter = Parameter::preload, .min = 60, .max = 300}};
    study.objective = {parse_metric("max_pressure"), false, {}};
    study.constraints = {parse_limit(limit)};
    study.tolerances = {{.parameter = Parameter::kinetic_friction, .sd = Spread{0.03, true}}};
    study.statistics = {parse_statistic_limit("yield >= 95 %")};
    return optimum(run_study(asking(study))).best.design.front().value;
  };
  CHECK(built("grip >= 0.4 N.m") == built("holding_torque >= 0.4 N.m"));
}

TEST_CASE("no directory keeps a study of an own metric", "[studies][own]") {
  const twum::test::ScratchFolder folder;
  const StudyFile study = asking(cheap("grip >= 600 N.mm"));
  CHECK_NOTHROW(validate(study));
  CHECK_THROWS_WITH(run_study(study, folder.path("out")),
                    Contains("is a metric of this program, which a study file cannot have"));
}

TEST_CASE("what is wrong about an own metric in a study is said", "[studies][own]") {
  CHECK_THROWS_WITH(parse_metric("cost"), Contains("unknown metric 'cost'"));
  const KnownMetrics known({cost(), grip()});
  CHECK_THROWS_WITH(parse_limit("cost <= 3 N"), Contains("force"));
  CHECK_THROWS_WITH(parse_metric("cost(3)"), Contains("takes nothing in parentheses"));
  CHECK_THROWS_WITH(parse_metric("gripp"), Contains("grip"));
  OptimizeStudy two = cheap("grip >= 600 N.mm");
  OwnMetric other = grip();
  other.unit = "1";
  two.constraints.push_back({"grip <= 2", expression_of(other), 0, 2});
  CHECK_THROWS_WITH(validate(asking(two)), Contains("two metrics of this name"));
  OptimizeStudy twice = cheap("grip >= 600 N.mm");
  twice.constraints.push_back(twice.constraints[0]);
  CHECK_THROWS_WITH(validate(asking(twice)),
                    Contains("study.constraints: 'grip >= 600 N.mm' is given twice"));
}
