// SPDX-License-Identifier: Apache-2.0
// Searches that find no design to begin with, evaluators that do not keep what they promise, and
// what is said of stages that came to nothing.
#include "optim/bank/dual_problem.hpp"

#include <twum/base/error.hpp>
#include <twum/optim/pareto.hpp>
#include <twum/optim/solve.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <set>

using namespace twum;
using namespace twum::optim;
using Catch::Matchers::Contains;

namespace {

using D = Dual<double, 2>;

Problem bowl() {
  Problem p;
  p.variables = test::box(2, -2.0, 2.0, {1.0, -1.0});
  p.objectives = {{"f"}};
  p.evaluate = test::dual_evaluator<2>(
      1, [](const D* x, D* r) { r[0] = (x[0] - 0.3) * (x[0] - 0.3) + x[1] * x[1]; });
  return p;
}

Problem torn() {
  Problem p = bowl();
  p.evaluate = [](std::span<const double>, bool) { return Evaluation{{}, {}, {}, "torn"}; };
  return p;
}

}  // namespace

TEST_CASE(
    "where nothing can be evaluated no design is tried twice, and not the whole budget is spent",
    "[optim][failure]") {
  std::size_t tried = 0;
  for (const std::size_t budget : {5000U, 20000U}) {
    std::set<std::vector<double>> designs;
    SolveOptions options;
    options.budget.evaluations = budget;
    options.observer = [&](const Observation& o) {
      designs.emplace(o.design.begin(), o.design.end());
    };
    const Result r = solve(torn(), options);
    CHECK(r.outcome == Outcome::failed);
    CHECK(designs.size() == r.counters.evaluations);
    CHECK(r.counters.evaluations > 1);
    CHECK(r.counters.evaluations < 5000);
    if (tried > 0) CHECK(r.counters.evaluations == tried);
    tried = r.counters.evaluations;
  }
}

TEST_CASE("a search begins in a 200th of the range if nothing else can be evaluated",
          "[optim][failure]") {
  Problem p = bowl();
  const auto whole = p.evaluate;
  p.evaluate = [whole](std::span<const double> x, bool gradients) {
    const bool inside = std::fabs(x[0] - 0.3) < 0.14 && std::fabs(x[1]) < 0.14;
    return inside ? whole(x, gradients) : Evaluation{{}, {}, {}, "torn"};
  };
  const Result r = solve(p);
  REQUIRE(r.evaluation.ok());
  // The least value, f = 0, lies inside.
  CHECK(r.evaluation.values[0] < 1e-6);
}

TEST_CASE("where nothing can be evaluated and nothing varies there is one design to try",
          "[optim][failure]") {
  Problem p = torn();
  for (Variable& v : p.variables) v.lower = v.upper = 1.0;
  const Result r = solve(p);
  CHECK(r.outcome == Outcome::failed);
  CHECK(r.counters.evaluations == 1);
}

TEST_CASE("a stage that could not look at any design has found none",
          "[optim][budget][definition]") {
  // The one call goes to the start, and none is left to any solver.
  std::size_t stages = 0;
  for (const std::string solver : {"auto", "nlopt:slsqp", "nlopt:cobyla"}) {
    SolveOptions options;
    options.solver = solver;
    options.budget.evaluations = 1;
    for (const StageReport& stage : solve(bowl(), options).stages) {
      CAPTURE(solver, stage.solver);
      CHECK(stage.evaluations == 0);
      CHECK(std::isnan(stage.objective));
      CHECK_FALSE(stage.feasible);
      ++stages;
    }
  }
  CHECK(stages >= 3);
}

TEST_CASE("a Jacobian of the wrong size is refused, also where it is left out or was not asked for",
          "[optim][error]") {
  Problem p = bowl();
  const Evaluator right = p.evaluate;
  p.evaluate = [&](std::span<const double> x, bool gradient) {
    Evaluation e = right(x, gradient);
    e.jacobian.clear();
    return e;
  };
  CHECK_THROWS_WITH(solve(p), Contains("gave 0 derivatives where 2 were expected"));
  p.evaluate = [&](std::span<const double> x, bool gradient) {
    Evaluation e = right(x, gradient);
    if (!gradient) e.jacobian.pop_back();
    return e;
  };
  SolveOptions options;
  options.solver = "nlopt:cobyla";
  CHECK_THROWS_WITH(solve(p, options), Contains("gave 1 derivatives where 2 were expected"));
}

TEST_CASE("where nothing can be evaluated a solve and a front say the same, whatever the budget",
          "[optim][failure][budget]") {
  for (const std::size_t budget : {1U, 2U, 3U, 1000U}) {
    CAPTURE(budget);
    SolveOptions options;
    options.budget.evaluations = budget;
    CHECK(solve(torn(), options).outcome == Outcome::failed);
    Problem two = torn();
    two.objectives.push_back({"g"});
    ParetoOptions front;
    front.solve = options;
    CHECK(pareto_front(two, front).outcome == Outcome::failed);
  }
}
