// SPDX-License-Identifier: Apache-2.0
// Local searches from several starts on problems with known answers, what a search starts from, and what
// the report of a design says.
#include "entries_support.hpp"
#include "kinds/rows/design_report.hpp"
#include "problem/motor_responses.hpp"
#include "problem/multi_start.hpp"
#include "support/constants.hpp"

#include <twum/base/error.hpp>
#include <twum/io/result_store.hpp>
#include <twum/studies/sizing.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

using namespace twum;
using namespace twum::studies;
using namespace twum::test;
using optim::Outcome;
using P = Parameter;

namespace {

// x^4 - 2 x^2 + x / 4 has two valleys; the left one is the deeper.
optim::Problem two_valleys() {
  optim::Problem problem;
  problem.variables = {{"x", -2, 2, 1.5}};
  problem.objectives = {{"f", optim::Sense::minimize}};
  problem.evaluate = [](std::span<const double> x, bool) {
    const double v = x[0];
    return optim::Evaluation{
        {v * v * v * v - 2 * v * v + v / 4}, {4 * v * v * v - 4 * v + 0.25}, {}, {}};
  };
  return problem;
}

// x + y within [0, 1]^2, where x + y >= `least`.
optim::Problem corner(double least) {
  optim::Problem problem;
  problem.variables = {{"x", 0, 1, 0.3}, {"y", 0, 1, 0.4}};
  problem.objectives = {{"x + y", optim::Sense::minimize}};
  problem.constraints = {{"limit", least}};
  problem.evaluate = [](std::span<const double> x, bool) {
    return optim::Evaluation{{x[0] + x[1], x[0] + x[1]}, {1, 1, 1, 1}, {}, {}};
  };
  return problem;
}

optim::SolveOptions with_starts(std::size_t starts) {
  optim::SolveOptions options;
  options.solver = "nlopt:slsqp";
  options.starts = starts;
  options.scan = 0;  // what the starts find by themselves
  return options;
}

// Where a search begins, and what the design that it finds is made of.
struct Begun {
  std::vector<double> first;
  std::vector<NamedValue> best;

  explicit Begun(const StudyFile& file) {
    const auto kind = make_kind(file);
    ResultStore store(":memory:", kind->columns());
    ThreadExecutor executor(*kind);
    RunContext context{store, executor, {}, {}};
    best = std::get<OptimizeResult>(kind->run(context).answer).best.design;
    store.read([&](const StoredRow& row) {
      if (first.empty()) first = row.values;
    });
  }
};

MotorDesign elastic() {
  const ScratchFolder folder;
  return study_in(folder, "{kind: curve, points: 3}").motor.design;
}

}  // namespace

TEST_CASE("several starts find the deeper of two valleys, and all that they cost is counted",
          "[studies][problem]") {
  const optim::Problem problem = two_valleys();
  const optim::Result one = solve_from_starts(problem, with_starts(1));
  const optim::Result many = solve_from_starts(problem, with_starts(8));
  CHECK(one.design[0] > 0);  // begun at 1.5
  CHECK(many.design[0] < 0);
  // Both are zeros of the slope 4 x^3 - 4 x + 1/4.
  for (const double x : {one.design[0], many.design[0]})
    CHECK(4 * x * x * x - 4 * x + 0.25 == Approx(0).margin(1e-4));
  CHECK(many.outcome == Outcome::optimal);
  CHECK(many.counters.evaluations > one.counters.evaluations);
  CHECK(many.stages_used >= 8);

  // The same upside down.
  optim::Problem hills = problem;
  hills.objectives[0].sense = optim::Sense::maximize;
  hills.evaluate = [valleys = problem.evaluate](std::span<const double> x, bool gradient) {
    optim::Evaluation e = valleys(x, gradient);
    e.values[0] = -e.values[0];
    e.jacobian[0] = -e.jacobian[0];
    return e;
  };
  CHECK(solve_from_starts(hills, with_starts(8)).design[0] == Approx(many.design[0]).epsilon(1e-6));
}

TEST_CASE("one start ends in the wrong valley, and a sample of the range shows the other",
          "[studies][problem]") {
  optim::SolveOptions options = with_starts(1);
  options.scan = 512;
  const optim::Result result = solve_from_starts(two_valleys(), options);
  CHECK(result.outcome == Outcome::optimal);
  CHECK(result.design[0] < 0);
  CHECK(result.scan.replaced);
}

TEST_CASE("a logarithmic variable is started evenly by ratio", "[studies][problem]") {
  // (log x)^2 has its only minimum at 1, in the middle of the scale from 1e-3 to 1e3.
  optim::Problem problem;
  problem.variables = {{"x", 1e-3, 1e3, 500, optim::Scale::log}};
  problem.objectives = {{"f", optim::Sense::minimize}};
  std::vector<double> small;
  problem.evaluate = [&](std::span<const double> x, bool) {
    if (x[0] < 0.1) small.push_back(x[0]);
    const double log = std::log(x[0]);
    return optim::Evaluation{{log * log}, {2 * log / x[0]}, {}, {}};
  };
  const optim::Result result = solve_from_starts(problem, with_starts(8));
  CHECK(result.design[0] == Approx(1).epsilon(1e-4));
  CHECK_FALSE(small.empty());  // a linear scale would start below 0.1 once in ten thousand times
}

TEST_CASE("where no start leads to a feasible design the least infeasible one is explained",
          "[studies][problem]") {
  const optim::Result result = solve_from_starts(corner(3), with_starts(3));
  CHECK(result.outcome == Outcome::infeasible);
  // x + y is 2 at most: the limit of 3 has to give way by 1.
  CHECK(result.design[0] == Approx(1).epsilon(1e-6));
  CHECK(result.design[1] == Approx(1).epsilon(1e-6));
  REQUIRE(result.infeasibility.relaxations.size() == 1);
  CHECK(result.infeasibility.relaxations[0].amount == Approx(1).epsilon(1e-6));
  CHECK(solve_from_starts(corner(1.5), with_starts(3)).outcome == Outcome::optimal);
}

TEST_CASE("a problem that cannot be evaluated fails from every start", "[studies][problem]") {
  optim::Problem problem = corner(1);
  problem.evaluate = [](std::span<const double>, bool) {
    return optim::Evaluation{{}, {}, {}, "no answer"};
  };
  const optim::Result result = solve_from_starts(problem, with_starts(3));
  CHECK(result.outcome == Outcome::failed);
  CHECK(result.counters.failures.at("no answer") == result.counters.evaluations);
}

TEST_CASE("starts that cannot be evaluated do not hide one that can", "[studies][problem]") {
  optim::Problem problem = two_valleys();
  problem.evaluate = [valleys = problem.evaluate](std::span<const double> x, bool gradient) {
    if (x[0] > 0) return optim::Evaluation{{}, {}, {}, "no answer"};
    return valleys(x, gradient);
  };
  const optim::Result result = solve_from_starts(problem, with_starts(8));
  CHECK(result.outcome == Outcome::optimal);
  CHECK(result.design[0] < -0.9);
}

TEST_CASE("a budget that runs out between starts leaves what was found, and says so",
          "[studies][problem]") {
  optim::SolveOptions options = with_starts(50);
  options.budget.evaluations = 20;
  const optim::Result found = solve_from_starts(two_valleys(), options);
  CHECK(found.counters.evaluations <= 20);
  CHECK_FALSE(found.design.empty());
  options.budget.evaluations = 2;
  const optim::Result infeasible = solve_from_starts(corner(3), options);
  CHECK(infeasible.outcome == Outcome::budget);
  CHECK(infeasible.stop == optim::StopReason::evaluations);
}

TEST_CASE("a request to stop ends the starts", "[studies][problem]") {
  std::stop_source stop;
  optim::SolveOptions options = with_starts(50);
  options.stop = stop.get_token();
  std::size_t count = 0;
  options.observer = [&](const optim::Observation&) {
    if (++count == 30) stop.request_stop();
  };
  const optim::Result result = solve_from_starts(corner(3), options);
  CHECK(result.stop == optim::StopReason::requested);
  CHECK(result.outcome == Outcome::budget);
  CHECK(result.counters.evaluations < 100);
}

TEST_CASE("solvers that look everywhere themselves are started once", "[studies][problem]") {
  optim::SolveOptions options = with_starts(8);
  options.solver = "nlopt:direct_l";
  options.budget.evaluations = 300;
  const optim::Result result = solve_from_starts(two_valleys(), options);
  CHECK(result.stages_used < 8);
  CHECK(result.design[0] == Approx(-1.03).margin(0.01));  // from -1 by 0.25 / 8 to first order
}

TEST_CASE("a duty needs a point, and quantities of the right dimension", "[studies][size]") {
  DesignProblem problem{elastic()};
  problem.vary(P::preload, 60, 300);
  CHECK_THROWS_WITH(size(problem, std::vector<DutyPoint>{}),
                    "a duty needs at least one operating point");
  CHECK_THROWS_WITH(duty_point("0.5 N", "100 rpm"),
                    Catch::StartsWith("torque: '0.5 N' is a force [N]"));
  CHECK_THROWS_WITH(duty_point("0.5 N.m", "100"), Catch::StartsWith("speed: '100' has no unit"));
  // 0.5 N.m at 1 rpm, on the plateau, needs a preload of 0.5 / (mu r), and the least pressure is there.
  const DesignAnswer answer = size(problem, duty_point("0.5 N.m", "1 rpm"));
  CHECK(answer.motor.preload == Approx(0.5 / (0.2 * 0.0265)).epsilon(1e-5));
  problem.maximize("stall_torque").limit("preload <= 250 N");
  CHECK(size(problem, duty_point("0.5 N.m", "1 rpm")).motor.preload == Approx(250).epsilon(1e-5));
}

TEST_CASE("what an earlier study changed is the motor, varied or not", "[studies][optimize]") {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder.path("first"));
  write(folder.path("first/summary.json"),
        R"({"best": {"design": {"preload": 123, "amplitude": 1.5e-6}}})");
  const std::string search =
      "{kind: optimize, maximize: stall_torque, start: first, solver: {name: nlopt:slsqp, starts: "
      "1, "
      "max_evaluations: 20}, variables: {";
  const std::vector<std::string> others{
      "kinetic_friction: {min: 0.1, max: 0.3}", "thickness: {min: 0.2 mm, max: 0.4 mm}",
      "contact_width: {min: 3 mm, max: 5 mm}", "frequency: {min: 38 kHz, max: 42 kHz}",
      "neutral_plane_distance: {min: 2 mm, max: 4 mm}"};
  for (std::size_t before = 0; before <= others.size(); ++before) {
    std::string variables;
    for (std::size_t i = 0; i < before; ++i) variables += others[i] + ", ";
    variables += "preload: {min: 100 N, max: 200 N}";
    for (std::size_t i = before; i < others.size(); ++i) variables += ", " + others[i];
    CAPTURE(variables);
    const Begun begun(study_in(folder, search + variables + "}}"));
    REQUIRE(begun.best.size() == others.size() + 2);
    CHECK(begun.best[before].name == "preload");
    CHECK(begun.first[before] == 123);
    CHECK(begun.best.back().name == "amplitude");  // not varied, and changed all the same
    CHECK(begun.best.back().value == 1.5e-6);
  }
  // A start of its own goes before that of the earlier design.
  const Begun own(study_in(folder, search + "preload: {min: 100 N, max: 200 N, start: 150 N}}}"));
  CHECK(own.first[0] == 150);
}

TEST_CASE("limits that would have to be loosened are named as they were typed",
          "[studies][optimize]") {
  DesignProblem problem{elastic()};
  problem.vary(P::preload, 60, 300).maximize("peak_power");
  const std::vector<std::string> texts{"stall_torque >= 1 N.m", "no_load_speed >= 1 rpm",
                                       "max_pressure <= 1 MPa", "contact_ratio <= 0.4",
                                       "max_torque >= 1 mN.m",  "preload <= 200 N"};
  for (std::size_t count = 1; count <= texts.size(); ++count) {
    problem.limit(texts[count - 1]);
    const DesignReporter reporter(problem, {});
    for (std::size_t i = 0; i < count; ++i) {
      optim::Infeasibility found;
      found.relaxations = {{"of nobody", optim::Side::upper, 1, 1, 1},
                           {texts[i], optim::Side::upper, 1, 0.25, kNaN}};
      const auto states = reporter.explanation(found).limits;
      REQUIRE(states.size() == 1);
      CHECK(states[0].text == texts[i]);
      CHECK(states[0].amount == 0.25);
      CHECK(std::isnan(states[0].amount_alone));
    }
    // Each metric once, whether it was asked for or not.
    CHECK(reporter.metrics_of(problem.motor).size() ==
          plain_metrics(problem.motor).size() + (count == texts.size() ? 1 : 0));
  }
}

TEST_CASE("a report tells by how much a limit is broken, and which end of a range holds",
          "[studies][optimize]") {
  DesignProblem problem{elastic()};
  problem.vary(P::preload, 60, 300).vary(P::amplitude, 1.6e-6, 1.6e-6).maximize("peak_power");
  problem.limit("preload <= 200 N").limit("speed_at(9 N.m) >= 1 rpm").limit("preload >= 50 N");
  const DesignReporter reporter(problem, {});
  optim::Certificate certificate;
  certificate.limits = {{"preload", true, optim::Side::upper, 300, 300, 0, true, 0.5, 1},
                        {"amplitude", true, optim::Side::lower, 1.6e-6, 1.6e-6, 0, true, 2, 3},
                        {"preload <= 200 N", false, optim::Side::upper, 300, 200, 100, true, 4, 5}};
  const DesignReport report = reporter.report(std::vector<double>{300, 1.6e-6}, certificate);
  REQUIRE(report.constraints.size() >= 3);
  CHECK(report.constraints[0].violation == 100);
  CHECK(report.constraints[0].active);
  CHECK(report.constraints[0].multiplier == 4);
  CHECK(std::isnan(report.constraints[1].value));  // it carries no 9 N.m
  CHECK(std::isnan(report.constraints[1].violation));
  CHECK(report.constraints[2].violation == 0);
  CHECK_FALSE(report.constraints[2].active);
  // A range of one value holds nothing that could be had.
  REQUIRE(report.bounds.size() == 1);
  CHECK(report.bounds[0].variable.name == "preload");
  CHECK(report.bounds[0].upper);
  CHECK(report.bounds[0].multiplier == 0.5);

  // Idle is what moves neither the goal nor a limit that is active or broken.
  optim::Evaluation evaluation;
  CHECK(reporter.without_influence(evaluation, report)
            .empty());  // nothing is known without a Jacobian
  const std::size_t rows = 1 + report.constraints.size();
  evaluation.jacobian.assign(2 * rows, 0);
  evaluation.jacobian[0] = 1;  // the goal by the preload
  DesignProblem wide = problem;
  wide.variables[1].max = 2e-6;
  const DesignReporter other(wide, {});
  CHECK(other.without_influence(evaluation, report) == std::vector<std::string>{"amplitude"});
  evaluation.jacobian[2 * 3 + 1] = 1;  // an inactive limit by the amplitude
  CHECK(other.without_influence(evaluation, report) == std::vector<std::string>{"amplitude"});
  evaluation.jacobian[2 * 1 + 1] = 1e9;  // the broken limit by the amplitude
  CHECK(other.without_influence(evaluation, report).empty());
}
