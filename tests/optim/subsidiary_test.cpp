// SPDX-License-Identifier: Apache-2.0
// Searches around searches: augmented Lagrangians.
#include "optim/bank/dual_problem.hpp"

#include <twum/optim/solve.hpp>
#include <twum/optim/solvers.hpp>

#include <catch2/catch.hpp>

#include <cmath>

using namespace twum;
using namespace twum::optim;

namespace {

using D = Dual<double, 2>;

// (x - 1)^2 + 10 (y - x^2)^2 with x + y = 1 or at most that: a bent valley, so that one step of a
// search is far from enough.
Problem bent(bool equality) {
  Problem p;
  p.variables = test::box(2, -2.0, 2.0, {equality ? 1.9 : -1.0, 1.5});
  p.objectives = {{"f"}};
  p.constraints = {{"sum", equality ? 1.0 : -kInfinity, 1.0}};
  p.evaluate = test::dual_evaluator<2>(2, [](const D* x, D* r) {
    const D bend = x[1] - x[0] * x[0], rest = x[0] - 1.0;
    r[0] = rest * rest + 10.0 * (bend * bend);
    r[1] = x[0] + x[1];
  });
  return p;
}

// Along y = 1 - x the slope 2 (x - 1) - 20 (1 - x - x^2)(1 + 2 x) rises through zero once between
// 0.6 and 1.
double bent_optimum() {
  double low = 0.6, high = 1.0;
  for (int i = 0; i < 60; ++i) {
    const double x = 0.5 * (low + high);
    (2 * (x - 1) - 20 * (1 - x - x * x) * (1 + 2 * x) < 0 ? low : high) = x;
  }
  return low;
}

}  // namespace

TEST_CASE("an augmented Lagrangian ends at the optimum without Newton's help", "[optim]") {
  const double x = bent_optimum();
  const double least = (x - 1) * (x - 1) + 10 * std::pow(1 - x - x * x, 2);
  for (const bool equality : {false, true}) {  // each from a start in the valley of that optimum
    for (const std::string solver :
         {"nlopt:auglag", "nlopt:auglag_eq", "nlopt:mma", "nlopt:ccsaq"}) {
      SolveOptions options;
      options.solver = solver;
      options.polish = false;
      const Result r = solve(bent(equality), options);
      CAPTURE(equality, solver, x);
      REQUIRE_FALSE(r.stages.empty());
      // A violation of 1e-8 in units of the box, which is 4 wide, gains 4e-8 times the limit's
      // price; that is below 1. The solvers stop at steps of 1e-11: a margin for their rest.
      CHECK(std::abs(r.stages.front().objective - least) < 1e-6);
    }
  }
}
