// SPDX-License-Identifier: Apache-2.0
// What NSGA-II does with whole numbers, designs without an answer, limits and objectives that are met
// everywhere or nowhere, and the smallest population.
#include <twum/base/error.hpp>
#include <twum/optim/pareto.hpp>

#include <catch2/catch.hpp>

#include <cmath>

using namespace twum;
using namespace twum::optim;
using Catch::Matchers::Contains;

namespace {

using Designs = std::vector<std::vector<double>>;

// x and -x over [0, 1], with a Jacobian.
Problem trade() {
  Problem p;
  p.variables = {{"x", 0.0, 1.0, 0.25}};
  p.objectives = {{"up"}, {"down"}};
  p.evaluate = [](std::span<const double> x, bool) {
    return Evaluation{{x[0], -x[0]}, {1.0, -1.0}, {}, {}};
  };
  return p;
}

// The same with a limit on x.
Problem limited(const Constraint& limit) {
  Problem p = trade();
  p.constraints = {limit};
  p.evaluate = [](std::span<const double> x, bool) {
    return Evaluation{{x[0], -x[0], x[0]}, {1.0, -1.0, 1.0}, {}, {}};
  };
  return p;
}

Nsga2Options small(std::size_t population, std::size_t generations) {
  Nsga2Options options;
  options.population = population;
  options.generations = generations;
  return options;
}

void check_nothing(const Front& front, Outcome outcome) {
  CHECK(front.outcome == outcome);
  CHECK(front.points.empty());
  CHECK(front.reference.empty());
  CHECK(front.hypervolume == 0.0);
}

}  // namespace

TEST_CASE("a population of whole numbers has no others, in any place", "[optim][pareto][integer]") {
  Problem p;
  p.variables = {{"i", -3.5, 3.5}, {"x", 0.0, 1.0}, {"j", 0.0, 5.0}, {"k", -9.0, 9.0}};
  for (const std::size_t place : {0U, 2U, 3U}) p.variables[place].integer = true;
  p.objectives = {{"near"}, {"far"}};
  p.evaluate = [](std::span<const double> x, bool) {
    double near = 0.0, far = 0.0;
    for (const double t : x) near += t * t, far += (t - 1.3) * (t - 1.3);
    return Evaluation{{near, far}, {}, {}, {}};
  };
  Nsga2Options options = small(20, 5);
  std::size_t seen = 0, between = 0;
  options.solve.observer = [&](const Observation& o) {
    ++seen;
    for (const std::size_t place : {0U, 2U, 3U})
      CHECK(o.design[place] == std::round(o.design[place]));
    CHECK(std::abs(o.design[0]) <= 3.0);  // the whole numbers of its bounds
    if (o.design[1] != std::round(o.design[1])) ++between;
  };
  const Front front = nsga2(p, options);
  CHECK(seen > 50);  // of 120, less what is repeated
  CHECK(between > seen / 2);
  CHECK(front.outcome == Outcome::feasible);
}

TEST_CASE("a front of nothing is failed or infeasible and has no volume",
          "[optim][pareto][infeasible][failure]") {
  Problem torn = trade();
  torn.evaluate = [](std::span<const double>, bool) { return Evaluation{{}, {}, {}, "torn"}; };
  check_nothing(nsga2(torn, small(8, 3)), Outcome::failed);
  check_nothing(pareto_front(torn), Outcome::failed);
  const Problem never = limited({"high", 3.0});
  check_nothing(nsga2(never, small(8, 3)), Outcome::infeasible);
  check_nothing(pareto_front(never), Outcome::infeasible);
  // Some designs cannot be evaluated and the others break the limit.
  Problem both = never;
  both.evaluate = [whole = never.evaluate](std::span<const double> x, bool gradient) {
    return x[0] < 0.5 ? Evaluation{{}, {}, {}, "torn"} : whole(x, gradient);
  };
  check_nothing(nsga2(both, small(8, 3)), Outcome::infeasible);
}

TEST_CASE("a young population's front holds its limits as well", "[optim][pareto]") {
  // Half of the first population breaks the limit, by less than 1.
  for (const std::size_t generations : {0U, 1U, 10U}) {
    const Front front = nsga2(limited({"half", -kInfinity, 0.5}), small(20, generations));
    CAPTURE(generations);
    CHECK(front.outcome == Outcome::feasible);
    CHECK(front.points.size() > 5);
    // It gives way by the feasibility tolerance of 1e-8 relative to 1.5.
    for (const FrontPoint& point : front.points) CHECK(point.design[0] <= 0.5 + 1.5e-8);
  }
}

TEST_CASE("an objective that is the same everywhere does not change a population",
          "[optim][pareto][identity]") {
  // Neither who dominates whom nor who is crowded asks for it.
  const auto designs = [](bool with_constant) {
    Problem p;
    p.variables = {{"x", 0.0, 1.0}, {"y", -1.0, 1.0}};
    p.objectives = {{"near"}, {"far"}};
    if (with_constant) p.objectives.push_back({"same"});
    p.evaluate = [with_constant](std::span<const double> x, bool) {
      const double height = x[1] * x[1];
      Evaluation e{{x[0] * x[0] + height, (x[0] - 1.0) * (x[0] - 1.0) + height}, {}, {}, {}};
      if (with_constant) e.values.push_back(7.0);
      return e;
    };
    Nsga2Options options = small(20, 15);
    Designs seen;
    options.solve.observer = [&](const Observation& o) {
      seen.emplace_back(o.design.begin(), o.design.end());
    };
    nsga2(p, options);
    return seen;
  };
  const Designs plain = designs(false);
  CHECK(plain.size() > 200);  // of 320, less what is repeated
  CHECK(designs(true) == plain);
}

TEST_CASE("the smallest population is four, and it is even", "[optim][pareto][error]") {
  const Front front = nsga2(trade(), small(4, 3));
  CHECK(front.outcome == Outcome::feasible);
  CHECK(front.counters.evaluations + front.counters.reused == 16);  // 4 and 3 times 4
  for (const std::size_t refused : {0U, 2U, 3U, 5U})
    CHECK_THROWS_WITH(nsga2(trade(), small(refused, 3)),
                      Contains("the population must be even and at least 4"));
}
