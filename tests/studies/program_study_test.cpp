// SPDX-License-Identifier: Apache-2.0
// A study that a program makes is checked like a study file.
#include <twum/base/error.hpp>
#include <twum/optim/check_derivatives.hpp>
#include <twum/studies/run_study.hpp>
#include <twum/studies/sizing.hpp>

#include "support/motor_files.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <type_traits>

using namespace twum;
using namespace twum::studies;
using Catch::Contains;

namespace {

StudyFile asking(Study study, const MotorDesign& motor = {}) {
  return {.motor = {"m", motor}, .asked = std::move(study)};
}

// Refused with the name of the entry, both by validate() and by a run in memory.
void check_refused(const Study& study, const std::string& entry, const MotorDesign& motor = {}) {
  CAPTURE(entry);
  CHECK_THROWS_AS(validate(asking(study, motor)), InputError);
  CHECK_THROWS_WITH(validate(asking(study, motor)), Contains(entry));
  CHECK_THROWS_WITH(run_study(asking(study, motor)), Contains(entry));
}

SweepStudy sweep() {
  SweepStudy s;
  s.variables = {{.parameter = Parameter::preload, .values = {60, 70, 80}}};
  s.metrics = parse_metric_list("stall_torque");
  return s;
}

UncertaintyStudy uncertainty() {
  UncertaintyStudy u;
  u.variables = {Tolerance{.parameter = Parameter::preload, .sd = Spread{0.03, true}}};
  u.metrics = parse_metric_list("holding_torque");
  u.samples = 10;
  return u;
}

OptimizeStudy optimum() {
  OptimizeStudy o;
  o.variables = {{.parameter = Parameter::preload, .min = 60, .max = 300}};
  o.objective = {parse_metric("holding_torque"), true, {}};
  return o;
}

template <typename S>
S changed(S study, void (*change)(S&)) {
  change(study);
  return study;
}

}  // namespace

TEST_CASE("studies of a program that are right run", "[studies][validate]") {
  CHECK(run_study(asking(sweep())).outcome == "done");
  CHECK(run_study(asking(uncertainty())).outcome == "done");
  CHECK(run_study(asking(optimum())).outcome == "optimal");
  CHECK(run_study(asking(CurveStudy{})).outcome == "done");
  for (const Sampling sampling : {Sampling::lhs, Sampling::sobol}) {
    SweepStudy drawn = sweep();
    drawn.sampling = sampling;
    drawn.variables = {{.parameter = Parameter::preload, .values = {}, .min = 60, .max = 70}};
    drawn.samples = 4;
    CHECK(run_study(asking(drawn)).outcome == "done");
  }
}

TEST_CASE("lists of unequal length are refused", "[studies][validate]") {
  SweepStudy uneven = sweep();
  uneven.sampling = Sampling::list;
  uneven.variables.push_back({.parameter = Parameter::amplitude, .values = {1e-6}});
  check_refused(uneven, "study.variables.amplitude: 1 value, but preload has 3");
}

TEST_CASE("an empty list is refused where a value is needed", "[studies][validate]") {
  FrequencyStudy loads;
  loads.torque = std::vector<double>{};
  check_refused(loads, "study.torque");
  CurveStudy family;
  family.family = CurveStudy::Family{Parameter::preload, {}};
  check_refused(family, "study.family.preload");
  check_refused(changed<SweepStudy>(sweep(), [](SweepStudy& s) { s.variables.clear(); }),
                "study.variables");
  check_refused(changed<SweepStudy>(sweep(), [](SweepStudy& s) { s.metrics.clear(); }),
                "study.metrics");
  check_refused(
      changed<UncertaintyStudy>(uncertainty(), [](UncertaintyStudy& u) { u.metrics.clear(); }),
      "study.metrics");
}

TEST_CASE("a number outside its range is refused", "[studies][validate]") {
  check_refused(
      changed<UncertaintyStudy>(uncertainty(), [](UncertaintyStudy& u) { u.quantiles = {2}; }),
      "study.quantiles[0]");
  check_refused(
      changed<UncertaintyStudy>(uncertainty(), [](UncertaintyStudy& u) { u.samples = 0; }),
      "study.samples");
  check_refused(
      changed<OptimizeStudy>(optimum(), [](OptimizeStudy& o) { o.solver.tolerance = -1; }),
      "study.solver.tolerance");
  check_refused(changed<OptimizeStudy>(optimum(),
                                       [](OptimizeStudy& o) { o.solver.tolerance = std::nan(""); }),
                "study.solver.tolerance");
  check_refused(
      changed<OptimizeStudy>(optimum(), [](OptimizeStudy& o) { o.variables[0].min = 400; }),
      "study.variables.preload.max");
  check_refused(
      changed<SweepStudy>(sweep(), [](SweepStudy& s) { s.sampling = static_cast<Sampling>(9); }),
      "study.sampling");
}

TEST_CASE("a grid of 65536^4 designs is refused", "[studies][validate]") {
  SweepStudy grid = sweep();
  grid.variables.clear();
  for (const Parameter p : {Parameter::preload, Parameter::amplitude, Parameter::thickness,
                            Parameter::kinetic_friction})
    grid.variables.push_back({.parameter = p,
                              .values = {},
                              .min = 0.5 * get(MotorDesign{}, p),
                              .max = get(MotorDesign{}, p),
                              .points = 65536});
  check_refused(grid, "study.variables: a grid of 1.84e+19 designs");  // 2^64
}

TEST_CASE("what is missing or given twice is refused", "[studies][validate]") {
  check_refused(changed<UncertaintyStudy>(uncertainty(),
                                          [](UncertaintyStudy& u) { u.variables[0].sd.reset(); }),
                "study.variables.preload");
  check_refused(
      changed<SweepStudy>(sweep(), [](SweepStudy& s) { s.variables.push_back(s.variables[0]); }),
      "study.variables.preload: given twice");
  check_refused(changed<OptimizeStudy>(optimum(), [](OptimizeStudy& o) { o.objective = {}; }),
                "study");
  SizeStudy size;
  size.variables = optimum().variables;
  check_refused(size, "study.duty");
  size.duty = {parse_limit("max_pressure <= 10 MPa")};  // a limit, but no load at a speed
  check_refused(size, "study.duty[0].speed");
}

TEST_CASE("a motor of a program is checked with its study", "[studies][validate]") {
  MotorDesign motor;
  motor.preload = std::nan("");
  CHECK_THROWS_WITH(validate(asking(sweep(), motor)), Contains("preload"));
  check_refused(FrequencyStudy{}, "motor: the amplitude of this motor is given");
}

TEST_CASE("a design of the wrong size is the caller's mistake", "[studies][validate]") {
  DesignProblem problem{MotorDesign{}};
  problem.vary(Parameter::preload, 60, 300).vary(Parameter::amplitude, 1e-6, 2e-6);
  problem.maximize("peak_power");
  const std::vector<double> one{100};
  const std::string words = "design: 1 value, but the problem has 2 variables and choices";
  CHECK_THROWS_AS(motor_of(problem, one), InputError);
  CHECK_THROWS_WITH(motor_of(problem, one), words);
  CHECK_THROWS_WITH(motor_problem(problem).evaluate(one, true), words);
}

TEST_CASE("a frequency study tells its progress from the beginning", "[studies][progress]") {
  FrequencyStudy study;
  study.points = 11;
  std::vector<std::uint64_t> done;
  RunOptions options;
  options.jobs = 1;
  options.progress = [&](const RunProgress& now) {
    CHECK(now.total == 22);  // two directions
    done.push_back(now.done);
  };
  MotorDesign motor = read_motor_file(twum::test::motor_path("drive-60")).design;
  motor = twum::with(motor, Parameter::radial_slices, 1);
  CHECK(run_study(asking(study, motor), options).outcome == "done");
  REQUIRE(!done.empty());
  CHECK(done.front() == 0);
  CHECK(done.back() == 22);
  CHECK(std::is_sorted(done.begin(), done.end()));
}

TEST_CASE("a frequency study that is stopped before it begins computes no sweep",
          "[studies][progress]") {
  std::stop_source source;
  source.request_stop();
  RunOptions options;
  options.stop = source.get_token();
  const MotorDesign motor = read_motor_file(twum::test::motor_path("drive-60")).design;
  const StudyResult result = run_study(asking(FrequencyStudy{}, motor), options);
  CHECK(result.outcome == "interrupted");
  CHECK(std::get<FrequencyResult>(result.answer).members.empty());
}

TEST_CASE("variables are given with a scale and a start, or as texts", "[studies][problem]") {
  DesignProblem numbers{MotorDesign{}};
  numbers.vary(Parameter::thickness, 1e-4, 1e-3, optim::Scale::log, 2e-4)
      .vary(Parameter::preload, 60, 300);
  REQUIRE(numbers.variables.size() == 2);
  CHECK(numbers.variables[0].scale == optim::Scale::log);
  CHECK(numbers.variables[0].start == 2e-4);
  CHECK(numbers.variables[1].scale == optim::Scale::linear);
  CHECK(std::isnan(numbers.variables[1].start));
  DesignProblem texts{MotorDesign{}};
  texts.vary("thickness", "0.1 mm", "1 mm", optim::Scale::log).vary("F_N", "60 N", "300 N");
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(texts.variables[i].parameter == numbers.variables[i].parameter);
    CHECK(texts.variables[i].min == Approx(numbers.variables[i].min).epsilon(1e-15));
    CHECK(texts.variables[i].max == Approx(numbers.variables[i].max).epsilon(1e-15));
    CHECK(texts.variables[i].scale == numbers.variables[i].scale);
  }
  CHECK_THROWS_AS(texts.vary("preload", "60 mm", "300 N"), InputError);
  // What once was a truth value: neither a word nor a number is a scale.
  CHECK(!std::is_convertible_v<const char*, optim::Scale>);
  CHECK(!std::is_convertible_v<double, optim::Scale>);
}

TEST_CASE("a limit on a metric is that of its text", "[studies][problem]") {
  const double none = optim::kInfinity;
  DesignProblem typed{MotorDesign{}}, text{MotorDesign{}};
  typed.limit(Metric::max_pressure, -none, 10e6).limit(Metric::no_load_speed, 10, none);
  typed.limit(Metric::max_efficiency, 0.2, 0.4);
  text.limit("max_pressure <= 10 MPa").limit("no_load_speed >= 10 rad/s");
  text.limit("0.2 <= max_efficiency <= 0.4");
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(typed.limits[i].lower == text.limits[i].lower);
    CHECK(typed.limits[i].upper == text.limits[i].upper);
    CHECK(typed.limits[i].metric.text == text.limits[i].metric.text);
  }
  CHECK_THROWS_AS(typed.limit(Metric::max_pressure, -none, none), InputError);
  CHECK_THROWS_AS(typed.limit(Metric::max_pressure, 2, 1), InputError);
}

TEST_CASE("a duty is named by the texts that it was typed with", "[studies][sizing]") {
  DesignProblem problem{MotorDesign{}};
  problem.vary(Parameter::preload, 60, 300).vary(Parameter::amplitude, 0.8e-6, 2.2e-6);
  const DesignAnswer best =
      size(problem, {duty_point("0.5 N.m", "100 rpm"), duty_point("0.6 N.m", "50 rpm")});
  CHECK(best.search.outcome == optim::Outcome::optimal);
  REQUIRE(best.search.certificate.limits.size() >= 2);
  CHECK(best.search.certificate.limits[0].name == "torque_at(100 rpm) >= 0.5 N.m");
  CHECK(best.search.certificate.limits[1].name == "torque_at(50 rpm) >= 0.6 N.m");
}

TEST_CASE("each wrong sign in the Jacobian of a design problem is found", "[studies][problem]") {
  DesignProblem question{MotorDesign{}};
  question.vary(Parameter::preload, 60, 300).vary(Parameter::amplitude, 0.8e-6, 2.2e-6);
  question.vary(Parameter::contact_radius, 20e-3, 30e-3);
  question.derive(Parameter::contact_width, "0.15 * contact_radius").maximize("peak_power");
  question.limit("max_pressure <= 3 MPa");
  optim::Problem problem = motor_problem(question);
  const std::vector<double> design = optim::start_design(problem);
  for (const auto& one : optim::check_derivatives(problem, design)) {
    CAPTURE(one.response, one.variable, one.given, one.difference, one.uncertainty);
    CHECK(one.agrees);
  }
  for (std::size_t k = 0; k < 6; ++k) {
    optim::Problem wrong = problem;
    wrong.evaluate = [k, right = problem.evaluate](std::span<const double> x, bool gradient) {
      optim::Evaluation e = right(x, gradient);
      if (gradient && e.ok()) e.jacobian[k] *= -1;
      return e;
    };
    const auto checks = optim::check_derivatives(wrong, design);
    REQUIRE(checks.size() == 6);
    // The pressure does not depend on every variable: a sign of 0 is not wrong.
    CHECK(checks[k].agrees == (checks[k].given == 0));
  }
}
