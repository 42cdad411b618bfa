// SPDX-License-Identifier: Apache-2.0
// What is said of problems without a feasible design, where the least infeasible one is known.
#include "search/causes.hpp"
#include "search/infeasibility.hpp"

#include "optim/bank/dual_problem.hpp"

#include <twum/optim/solve.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>

using namespace twum;
using namespace twum::optim;

namespace {

using D = Dual<double, 2>;
using Names = std::vector<std::string>;

// SLSQP stops at 1e-9 of scaled rows, whose scale is at most 20 here.
constexpr double kSolver = 1e-6;

Problem posed(std::vector<Constraint> constraints, std::function<void(const D*, D*)> f) {
  Problem p;
  p.variables = test::box(2, -10.0, 10.0, {3.0, 2.0});
  p.objectives = {{"f"}};
  p.constraints = std::move(constraints);
  p.evaluate = test::dual_evaluator<2>(p.responses(), std::move(f));
  return p;
}

// Two limits want x >= 1, and one wants x <= 0.
Problem outvoted() {
  return posed({{"one", 1.0}, {"two", 1.0}, {"none", -kInfinity, 0.0}}, [](const D* x, D* r) {
    r[0] = x[0] * x[0] + x[1];
    r[1] = r[2] = r[3] = x[0];
  });
}

// Both variables are wanted to be above 2 and below 1.
Problem two_quarrels() {
  return posed(
      {{"x high", 2.0}, {"x low", -kInfinity, 1.0}, {"y high", 2.0}, {"y low", -kInfinity, 1.0}},
      [](const D* x, D* r) {
        r[0] = x[0] + x[1];
        r[1] = r[2] = x[0];
        r[3] = r[4] = x[1];
      });
}

Infeasibility explained(const Problem& p, const std::vector<double>& unit) {
  const SolveOptions options;
  const Deadline deadline(kInfinity);
  StageRunner runner(p, options, deadline);
  runner.scale();
  return explain_infeasible(runner, unit).report;
}

// -10 to 10 in the unit box.
std::vector<double> unit(double x, double y) { return {(x + 10.0) / 20.0, (y + 10.0) / 20.0}; }

}  // namespace

TEST_CASE("the least infeasible design has the smallest sum of violations",
          "[optim][infeasible][closed_form]") {
  // Each step towards 1 mends two limits and breaks one: the sum is smallest at 1, where the
  // largest violation is not.
  for (const std::string solver : {"auto", "nlopt:slsqp"}) {
    SolveOptions options;
    options.solver = solver;
    const Result r = solve(outvoted(), options);
    CAPTURE(solver);
    REQUIRE(r.outcome == Outcome::infeasible);
    CHECK(r.infeasibility.design[0] == Approx(1.0).margin(kSolver));
    CHECK(r.infeasibility.certified);
    CHECK(r.design == r.infeasibility.design);
    for (const Relaxation& each : r.infeasibility.relaxations) {
      if (each.name != "none") continue;
      CHECK(each.amount == Approx(1.0).margin(kSolver));
      CHECK(each.amount_alone == Approx(1.0).margin(kSolver));
    }
  }
}

TEST_CASE("of two quarrels no limit alone can settle both", "[optim][infeasible][closed_form]") {
  const Result r = solve(two_quarrels());
  REQUIRE(r.outcome == Outcome::infeasible);
  CHECK(r.infeasibility.conflict == Names{"x high", "x low", "y high", "y low"});
  CHECK(r.infeasibility.relaxations.size() == 4);
  double sum = 0.0;
  for (const Relaxation& each : r.infeasibility.relaxations) {
    CAPTURE(each.name, each.amount_alone);
    CHECK(std::isnan(each.amount_alone));
    sum += each.amount;
  }
  CHECK(sum == Approx(2.0).margin(kSolver));
}

TEST_CASE("only a stationary point of the violation is called one", "[optim][infeasible]") {
  CHECK(explained(outvoted(), unit(1.0, 2.0)).certified);
  CHECK_FALSE(explained(outvoted(), unit(0.5, 2.0)).certified);
  // Two pull up, and the one that is met may push back with weight one, not two.
  CHECK_FALSE(explained(outvoted(), unit(0.0, 2.0)).certified);
  CHECK_FALSE(explained(outvoted(), unit(4.0, 2.0)).certified);
  CHECK(explained(two_quarrels(), unit(1.5, 1.0)).certified);
  CHECK_FALSE(explained(two_quarrels(), unit(3.0, 1.0)).certified);
}

TEST_CASE("nothing is said of limits at a design that cannot be evaluated",
          "[optim][infeasible][failure]") {
  Problem p = two_quarrels();
  p.evaluate = [whole = p.evaluate](std::span<const double> x, bool gradient) {
    return x[0] > 5.0 ? Evaluation{{}, {}, {}, "torn"} : whole(x, gradient);
  };
  const Infeasibility none = explained(p, unit(8.0, 1.0));
  CHECK(none.design == std::vector<double>{8.0, 1.0});
  CHECK(none.conflict.empty());
  CHECK(none.relaxations.empty());
  CHECK_FALSE(none.certified);
}

TEST_CASE("a search for the least loosening that needs none says so", "[optim][infeasible]") {
  // x >= 1 can be kept; an earlier search is said to have ended at x = 1/2.
  const Problem p = posed({{"one", 1.0}}, [](const D* x, D* r) {
    r[0] = x[0] * x[0] + x[1];
    r[1] = x[0];
  });
  Infeasibility before;
  before.design = {0.5, 2.0};
  before.relaxations = {{"one", Side::lower, 1.0, 0.5, 0.5}};
  const Causes causes = find_causes(p, {}, Deadline(kInfinity), 1000, before);
  REQUIRE(causes.feasible.size() == 2);
  CHECK(causes.feasible[0] >= 1.0);
  CHECK(causes.infeasibility.conflict.empty());
}
