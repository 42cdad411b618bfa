// SPDX-License-Identifier: Apache-2.0
// Fronts over whole numbers against curves in closed form.
#include "optim/bank/dual_problem.hpp"

#include <twum/optim/pareto.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <set>
#include <vector>

using namespace twum;
using namespace twum::optim;

namespace {

using D = Dual<double, 2>;

// F_1 = k + x, F_2 = -(k + x + 0.3 x (1 - x)) for k of 0, 1, 2 and x in [0, 1]: the pieces join at whole F_1, and none
// dominates another.
Problem three_pieces() {
  Problem p;
  p.variables = {{"k", 0, 2, 0}, {"x", 0, 1, 0.5}};
  p.variables[0].integer = true;
  p.objectives = {{"f1"}, {"f2"}};
  p.evaluate = test::dual_evaluator<2>(2, [](const D* x, D* r) {
    r[0] = x[0] + x[1];
    r[1] = -(x[0] + x[1] + 0.3 * x[1] * (1.0 - x[1]));
  });
  return p;
}

double second(double first) {
  const double x = first - std::floor(first);
  return -(first + 0.3 * x * (1 - x));
}

}  // namespace

TEST_CASE("a front over whole numbers has the pieces of all of them", "[optim][integer][pareto]") {
  ParetoOptions options;
  options.points = 30;
  options.reference = {4, 1};
  const Front front = pareto_front(three_pieces(), options);
  CHECK(front.outcome == Outcome::optimal);
  CHECK(front.points.size() == 30);
  std::set<double> whole;
  for (const FrontPoint& point : front.points) {
    CHECK(point.design[0] == std::round(point.design[0]));
    CHECK(point.certificate.passed);
    // On the curve by construction, up to rounding.
    CHECK(point.evaluation.values[1] == Approx(second(point.evaluation.values[0])).margin(1e-12));
    whole.insert(point.design[0]);
  }
  CHECK(whole.size() == 3);
  // The area under the reference, by the midpoint rule on the true curve; 30 steps lose about half a step's rectangle
  // each, 3 * 3 / 30 / 2 in all, of an area of some 8.
  double area = (4 - 3) * (1 - second(3));
  constexpr int kSteps = 30000;
  for (int i = 0; i < kSteps; ++i) area += (1 - second(3.0 * (i + 0.5) / kSteps)) * 3.0 / kSteps;
  CHECK(front.hypervolume < area);
  CHECK(front.hypervolume > area - 0.25);
}

TEST_CASE("whole numbers that a limit excludes are not on the front", "[optim][integer][pareto]") {
  Problem p = three_pieces();
  p.constraints = {{"k is 1 at least", 1.0}};
  p.evaluate = test::dual_evaluator<2>(3, [](const D* x, D* r) {
    r[0] = x[0] + x[1];
    r[1] = -(x[0] + x[1] + 0.3 * x[1] * (1.0 - x[1]));
    r[2] = x[0];
  });
  ParetoOptions options;
  options.points = 12;
  const Front front = pareto_front(p, options);
  CHECK(front.outcome == Outcome::optimal);
  for (const FrontPoint& point : front.points) CHECK(point.design[0] >= 1);
  p.constraints[0].lower = 5;
  CHECK(pareto_front(p, options).outcome == Outcome::infeasible);
}

TEST_CASE("a budget that ends between whole numbers is told", "[optim][integer][pareto]") {
  ParetoOptions options;
  options.points = 30;
  options.solve.budget.evaluations = 60;
  const Front front = pareto_front(three_pieces(), options);
  CHECK(front.outcome == Outcome::budget);
  CHECK(front.stop == StopReason::evaluations);
  CHECK(front.counters.evaluations <= 60);
}
