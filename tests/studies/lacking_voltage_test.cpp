// SPDX-License-Identifier: Apache-2.0
#include "results/standings.hpp"

#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>
#include <twum/motors/motor_file.hpp>
#include <twum/optim/solve.hpp>
#include <twum/studies/motor_problem.hpp>
#include <twum/studies/run_options.hpp>

#include "support/motor_files.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

// Searches of motors under a voltage that is at first too low to run them (Y5.4).
using namespace twum;
using namespace twum::studies;

namespace {

DesignProblem problem_of(double start) {
  DesignProblem problem{motors::read_motor_file(test::motor_path("drive-60")).design};
  problem.motor.stator.radial_slices = 1;
  problem.vary(Parameter::voltage, 2, 150, optim::Scale::linear, start)
      .vary(Parameter::preload, 60, 280)
      .vary(Parameter::thickness, 0.15e-3, 1e-3, optim::Scale::log);
  problem.minimize("electrical_power_at(0.4 N.m)");
  problem.limit("torque_at(60 rpm) >= 0.5 N.m");
  return problem;
}

}  // namespace

TEST_CASE("responses beside the motors that run are continuous, and their Jacobian is right (Y5.4)",
          "[studies][held][derivative]") {
  const DesignProblem question = problem_of(100);
  const optim::Problem problem = motor_problem(question);
  // Two voltages without a running wave, one with; power at a torque, torque at a speed, and the implied limits.
  for (const double voltage : {5.0, 20.0, 110.0}) {
    const std::vector<double> design{voltage, 160, 0.5e-3};
    const optim::Evaluation at = problem.evaluate(design, true);
    REQUIRE(at.ok());
    for (std::size_t j = 0; j < design.size(); ++j) {
      const double h = 2e-5 * design[j];
      const auto values = [&](double step) {
        std::vector<double> next = design;
        next[j] += step;
        return problem.evaluate(next, true).values;
      };
      const auto a = values(-2 * h), b = values(-h), c = values(h), d = values(2 * h);
      for (std::size_t i = 0; i < at.values.size(); ++i) {
        const double difference = (8 * (c[i] - b[i]) - (d[i] - a[i])) / (12 * h);
        CAPTURE(voltage, i, j);
        // Near the end of the running wave metrics go with the square root of 2e-3 of the voltage: the step is a hundredth of it.
        CHECK(at.jacobian[i * design.size() + j] * design[j] ==
              Approx(difference * design[j]).epsilon(2e-4).margin(2e-4 * std::fabs(at.values[i])));
      }
    }
  }
}

TEST_CASE("a motor that runs has its reserve of voltage as an implied limit, at most 1 (Y5.4)",
          "[studies][held]") {
  const DesignProblem question = problem_of(100);
  const optim::Problem problem = motor_problem(question);
  const auto reserve = [&](double voltage, const MetricRequest& request) {
    MotorDesign motor = with(question.motor, Parameter::voltage, voltage);
    motor.preload = 160, motor.layer.thickness = 0.5e-3;
    const MetricValue found = evaluate(Motor(motor), request);
    REQUIRE(found.status == MetricStatus::ok);
    return std::min(found.value, 1.0);
  };
  for (const double voltage : {80.0, 110.0, 149.0}) {
    CAPTURE(voltage);
    const optim::Evaluation at = problem.evaluate(std::vector<double>{voltage, 160, 0.5e-3}, true);
    REQUIRE(at.ok());
    // The goal, the limit, the largest torque, and the reserves of both.
    REQUIRE(at.values.size() == 5);
    CHECK(at.values[3] ==
          Approx(reserve(voltage, {Metric::voltage_reserve_at, Argument::torque, 0.4}))
              .epsilon(1e-12));  // the same sums
    CHECK(at.values[4] == Approx(reserve(voltage, {Metric::voltage_reserve_at, Argument::speed,
                                                   60 * std::numbers::pi / 30}))
                              .epsilon(1e-12));
  }
}

TEST_CASE("a search that starts where the motor does not run ends where another one does",
          "[studies][held]") {
  const optim::Result from_above = optim::solve(motor_problem(problem_of(120)));
  const optim::Result from_below = optim::solve(motor_problem(problem_of(4)));
  REQUIRE(from_above.outcome == optim::Outcome::optimal);
  REQUIRE(from_below.outcome == optim::Outcome::optimal);
  // Both are certified; a search ends within 1e-6 of its optimum.
  CHECK(from_below.evaluation.values[0] == Approx(from_above.evaluation.values[0]).epsilon(1e-5));
}

TEST_CASE(
    "an answer tells the voltage reserve that the metric has, not the search's stand-in for it "
    "(Y5.4)",
    "[studies][held]") {
  DesignProblem problem = problem_of(120);
  problem.variables.resize(1);  // the voltage
  problem.variables.front().min = 60;
  problem.limits.clear();
  OptimizeStudy asked;
  asked.variables = problem.variables;
  asked.objective = problem.objectives.front();
  asked.solver.starts = 1;
  const StudyResult result = run_study({.motor = {"drive-60", problem.motor}, .asked = asked});
  const DesignReport& best = std::get<OptimizeResult>(result.answer).best;
  const MotorDesign motor = with(problem.motor, Parameter::voltage, best.design.front().value);
  bool told = false;
  for (const LimitState& state : best.constraints) {
    if (state.metric != "voltage_reserve_at(0.4 N.m)") continue;
    told = true;
    const MetricValue value =
        evaluate(Motor(motor), {Metric::voltage_reserve_at, Argument::torque, 0.4});
    REQUIRE(value.status == MetricStatus::ok);
    CHECK(state.value == Approx(value.value).epsilon(1e-12));  // the same sums
    CHECK(state.implied);
    CHECK(state.violation == 0);
  }
  CHECK(told);
}

TEST_CASE(
    "a limit without a value that no motor breaks is not known, and one that a motor lacks is out "
    "of reach",
    "[studies][held]") {
  DesignReport report;
  LimitState state{"voltage_reserve_at(60 rpm) >= 0.002", "voltage_reserve_at(60 rpm)", "1"};
  state.at_least = state.implied = true;
  state.lower = state.limit = 0.002;
  state.value = std::nan("");
  report.constraints = {state};
  CHECK(standings_json(report, {{"peak_power", "W", true}})[0]["state"] == "unknown");
  report.constraints[0].violation = std::nan("");
  CHECK(standings_json(report, {{"peak_power", "W", true}})[0]["state"] == "unreachable");
}
