// SPDX-License-Identifier: Apache-2.0
#include "torque_problem.hpp"

#include "robust/ray.hpp"

#include <catch2/catch.hpp>

#include <twum/optim/robust_front.hpp>
#include <twum/optim/solve.hpp>

#include <cmath>

using namespace twum::optim;
using twum::test::linear_problem;

namespace {

constexpr double kIndex99 = 2.32634787404;  // Phi^-1(0.99), a textbook number

// Goals x1 and x2: with margins x_j >= Z_j the yield Phi(x1) Phi(x2) is limited, so that small x1 costs x2.
RobustProblem two_margins(double yield) {
  RobustProblem problem = linear_problem({{1.0, 0.0}, {0.0, 1.0}}, {1.0, 0.0}, yield);
  problem.design.objectives = {{"x1", Sense::minimize}, {"x2", Sense::minimize}};
  problem.design.evaluate = [](std::span<const double> x, bool) {
    return Evaluation{{x[0], x[1]}, {1.0, 0.0, 0.0, 1.0}, {}, {}};
  };
  problem.goals = {{RobustGoal::nominal, 0}, {RobustGoal::nominal, 1}};
  return problem;
}

double phi(double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); }

}  // namespace

TEST_CASE("every point of a front under tolerances keeps the yield and no more (U3.1, U7.1)",
          "[optim][robust]") {
  RobustOptions options;
  options.back_off = false;
  const RobustFront front = solve_robust_front(two_margins(0.99), 6, options);
  REQUIRE(front.points.size() >= 5);
  for (const RobustFrontPoint& point : front.points) {
    CHECK(point.certificate.passed);
    // The two margins are independent. 16,384 products about the worst points know the risk within 2 %.
    CHECK(1 - phi(point.design[0]) * phi(point.design[1]) == Approx(0.01).epsilon(0.02));
    CHECK(point.goals == point.design);
    CHECK(point.verdict != YieldVerdict::broken);
  }
  // Where one index goes to 6, the other spends the whole risk.
  CHECK(front.points.front().goals[0] == Approx(kIndex99).epsilon(0.01));
  CHECK(front.points.back().goals[1] == Approx(kIndex99).epsilon(0.01));
}

TEST_CASE("a front between a goal and the yield is the price of the yield (U3.6)",
          "[optim][robust]") {
  // One margin x - Z >= 0: the yield of x is Phi(x).
  RobustProblem problem = linear_problem({{1.0}}, {1.0}, 0.99);
  problem.design.variables[0].upper = 3.0;
  problem.goals = {{RobustGoal::nominal, 0}, {RobustGoal::yield, 0}};
  problem.yields[0].at_least = std::nan("");
  const RobustFront front = solve_robust_front(problem, 5);
  REQUIRE(front.points.size() >= 4);
  CHECK(front.outcome == Outcome::optimal);
  for (const RobustFrontPoint& point : front.points) {
    // The index is exact for one linear margin; its correction knows the risk within 2 %.
    CHECK(1 - point.goals[1] == Approx(1 - phi(point.design[0])).epsilon(0.02));
    const YieldEstimate& seen = point.verification.yields[0];
    // 99.99 % intervals of up to five points: a 95 % interval, twice as wide.
    const double room = seen.high - seen.low;
    CHECK(phi(point.design[0]) >= seen.low - room);
    CHECK(phi(point.design[0]) <= seen.high + room);
  }
}

TEST_CASE("a front whose yield cannot be reached tells the largest one (U3.6)", "[optim][robust]") {
  RobustProblem problem = two_margins(0.99);
  problem.design.variables[0].upper = 2.0;
  problem.design.variables[1].upper = 2.0;  // Phi(2)^2 = 95.5 %
  const RobustFront front = solve_robust_front(problem, 5);
  CHECK(front.outcome == Outcome::infeasible);
  CHECK(front.points.empty());
  REQUIRE(front.largest.yields.size() == 1);
  CHECK(front.largest.yields[0].low <= phi(2) * phi(2));
  CHECK(front.largest.yields[0].high >= phi(2) * phi(2));
}

TEST_CASE("a front under tolerances is the same for any number of threads", "[optim][robust]") {
  RobustOptions options;
  const RobustFront one = solve_robust_front(two_margins(0.95), 4, options);
  CHECK(one.outcome == Outcome::optimal);
  options.solve.jobs = 7;
  const RobustFront many = solve_robust_front(two_margins(0.95), 4, options);
  REQUIRE(one.points.size() == many.points.size());
  for (std::size_t i = 0; i < one.points.size(); ++i)
    CHECK(one.points[i].design == many.points[i].design);
  CHECK(one.hypervolume == many.hypervolume);
}
