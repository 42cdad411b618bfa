// SPDX-License-Identifier: Apache-2.0
// Which limits have to be loosened, and by how much, where that can be computed by hand.
#include "search/infeasibility.hpp"

#include "optim/bank/dual_problem.hpp"

#include <twum/optim/solve.hpp>

#include <catch2/catch.hpp>

#include <cmath>

using namespace twum;
using namespace twum::optim;

namespace {

// SLSQP stops at 1e-9 of scaled rows, whose scale is at most 20 here.
constexpr double kSolver = 1e-6;

// A variable, and each of some limits on it.
Problem limits_on(double lower, double upper, std::vector<Constraint> constraints) {
  Problem p;
  p.variables = test::box(1, lower, upper, {0.5});
  p.objectives = {{"f"}};
  p.constraints = std::move(constraints);
  p.evaluate = [rows = p.responses()](std::span<const double> x, bool) {
    return Evaluation{std::vector<double>(rows, x[0]), std::vector<double>(rows, 1.0), {}, {}};
  };
  return p;
}

Infeasibility explained(const Problem& p, double x) {
  const SolveOptions options;
  const Deadline deadline(kInfinity);
  StageRunner runner(p, options, deadline);
  REQUIRE(runner.scale());
  const Variable& v = p.variables[0];
  const std::vector<double> unit{(x - v.lower) / (v.upper - v.lower)};
  return explain_infeasible(runner, unit).report;
}

}  // namespace

TEST_CASE("unreachable limits are loosened by their distance to the bound, and only there",
          "[optim][infeasible][closed_form]") {
  // Bounds of 0 and 1 with one limit 1 beyond, and then one 2 beyond as well, from either side. In a box
  // that is one wide scaled violations are those in user units.
  for (const bool above : {true, false}) {
    for (const std::size_t many : {1U, 2U}) {
      CAPTURE(above, many);
      std::vector<Constraint> constraints;
      for (std::size_t i = 0; i < many; ++i) {
        const double beyond = 1.0 + static_cast<double>(i);
        constraints.push_back(above ? Constraint{test::numbered('c', i), 1.0 + beyond}
                                    : Constraint{test::numbered('c', i), -kInfinity, -beyond});
      }
      const Problem p = limits_on(0.0, 1.0, constraints);
      const double end = above ? 1.0 : 0.0;
      const Infeasibility there = explained(p, end);
      CHECK(there.certified);
      CHECK(there.conflict.size() == many);
      REQUIRE(there.relaxations.size() == many);
      for (std::size_t i = 0; i < many; ++i) {
        const Relaxation& one = there.relaxations[i];
        CHECK(one.name == constraints[i].name);
        CHECK(one.side == (above ? Side::lower : Side::upper));
        CHECK(one.limit == (above ? constraints[i].lower : constraints[i].upper));
        CHECK(one.amount == 1.0 + static_cast<double>(i));  // small whole numbers: exact
        if (many == 1) CHECK(one.amount_alone == Approx(1.0).margin(kSolver));
        if (many == 2) CHECK(std::isnan(one.amount_alone));  // the other one stays out of reach
      }
      for (const double inside : {0.1, 0.3, 0.9}) CHECK_FALSE(explained(p, inside).certified);
      const Result r = solve(p);
      REQUIRE(r.outcome == Outcome::infeasible);
      CHECK(r.infeasibility.certified);
      REQUIRE(r.infeasibility.design.size() == 1);
      CHECK(r.infeasibility.design[0] == Approx(end).margin(kSolver));
    }
  }
}

TEST_CASE("a limit that is met holds against one that is broken as far as its own weight goes",
          "[optim][infeasible][closed_form]") {
  // x <= 1 is met, q = x + x^2 / 2 >= 9 broken: in parts of its slope at the start 0.5 it rises by 4/3 at 1, more
  // than x <= 1 would lose, so the sum of violations falls further to the right; with q = x it does not.
  for (const bool bent : {false, true}) {
    Problem p = limits_on(-10.0, 10.0, {{"q", 9.0}, {"a", -kInfinity, 1.0}});
    if (bent)
      p.evaluate = [](std::span<const double> x, bool) {
        return Evaluation{{x[0], x[0] + 0.5 * x[0] * x[0], x[0]}, {1.0, 1.0 + x[0], 1.0}, {}, {}};
      };
    CAPTURE(bent);
    CHECK(explained(p, 1.0).certified == !bent);
  }
}
