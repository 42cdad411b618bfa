// SPDX-License-Identifier: Apache-2.0
#include "optim/bank/fronts.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <twum/optim/certify.hpp>
#include <twum/optim/hypervolume.hpp>
#include <twum/optim/pareto.hpp>

using namespace twum;
using namespace twum::optim;

namespace {

ParetoOptions options_for(const test::KnownFront& known) {
  ParetoOptions options;
  options.reference = known.reference;
  options.solve.budget.evaluations = 200000;
  return options;
}

std::size_t certified(const Front& front) {
  std::size_t count = 0;
  for (const auto& p : front.points) count += p.certificate.passed ? 1U : 0U;
  return count;
}

}  // namespace

TEST_CASE("100 points by gradients reach 99.9 percent of what any 100 points can have",
          "[optim][pareto][manufactured]") {
  for (const auto& known : test::known_fronts(1000)) {
    const Front front = pareto_front(known.problem, options_for(known));
    const double best = test::best_hypervolume(known.front, 100, known.reference);
    INFO(known.name << ": hypervolume " << front.hypervolume << ", best of 100 " << best
                    << ", ratio " << front.hypervolume / best << ", points " << front.points.size()
                    << ", certified " << certified(front) << ", evaluations "
                    << front.counters.evaluations << ", s " << front.seconds);
    CHECK(front.points.size() <= 100);
    CHECK(front.hypervolume >= 0.999 * best);
    CHECK(certified(front) == front.points.size());
    CHECK(front.counters.evaluations <= 10000);  // of 25,000 that a population takes
  }
}

TEST_CASE("the valley of ZDT4 is found whatever the seed", "[optim][pareto][manufactured]") {
  // 21^9 local fronts; the best of them is a quarter of the unit in f2 above the front.
  for (const auto& known : test::known_fronts(100)) {
    if (!known.many_local_fronts) continue;
    for (std::uint64_t seed = 2; seed < 6; ++seed) {
      ParetoOptions options = options_for(known);
      options.solve.seed = seed;
      const Front front = pareto_front(known.problem, options);
      INFO(known.name << ", seed " << seed);
      CHECK(front.hypervolume >= 0.998 * known.exact * 0.9948);  // 100 points have 99.48 % at most
    }
  }
}

TEST_CASE("a population can lead the way to the front", "[optim][pareto][manufactured]") {
  for (const auto& known : test::known_fronts(1000)) {
    if (!known.many_local_fronts) continue;
    ParetoOptions options = options_for(known);
    options.hops = 0;
    options.population_evaluations = 15000;
    const Front front = pareto_front(known.problem, options);
    CHECK(front.hypervolume >= 0.999 * test::best_hypervolume(known.front, 100, known.reference));
  }
}

TEST_CASE("three objectives: the fronts of DTLZ1 and DTLZ2", "[optim][pareto][manufactured]") {
  ParetoOptions options;
  options.solve.budget.evaluations = 200000;
  options.points = 100;
  options.reference = {0.5, 0.5, 0.5};
  const Front plane = pareto_front(test::dtlz1(), options);
  options.reference = {1.1, 1.1, 1.1};
  const Front sphere = pareto_front(test::dtlz2(), options);
  CHECK(plane.hypervolume >= 0.098);
  CHECK(sphere.hypervolume >= 0.750);
  CHECK(plane.hypervolume <= 0.125 - 1.0 / 48.0);  // of the whole front
  CHECK(sphere.hypervolume <= 1.331 - 3.141592653589793 / 6.0);
  CHECK(certified(plane) == plane.points.size());
  CHECK(certified(sphere) == sphere.points.size());
}

TEST_CASE("a budget that ends leaves enough for the certificates of the points",
          "[optim][pareto]") {
  for (const auto& known : test::known_fronts(10)) {
    if (known.name != "BNH" && known.name != "SRN") continue;
    ParetoOptions options = options_for(known);
    options.points = 20;
    options.solve.budget.evaluations = 200;
    const Front front = pareto_front(known.problem, options);
    CAPTURE(known.name, front.counters.evaluations);
    CHECK(front.outcome == Outcome::budget);
    CHECK(front.counters.evaluations <= 200);
    CHECK(front.points.size() >= 2);
    for (const FrontPoint& point : front.points)
      CHECK(point.certificate.stationarity > 0.0);  // measured, not left out
    CHECK(certified(front) == front.points.size());
  }
}

TEST_CASE("a population and gradients find the same front, gradients with fewer evaluations",
          "[optim][pareto][differential]") {
  for (const auto& known : test::known_fronts(100)) {
    if (known.name != "BNH" && known.name != "TNK" && known.name != "ZDT1") continue;
    const Front by_gradients = pareto_front(known.problem, options_for(known));
    Nsga2Options evolution;
    evolution.reference = known.reference;
    evolution.solve.budget.evaluations = 30000;
    const Front by_population = nsga2(known.problem, evolution);
    INFO(known.name);
    CHECK(by_population.hypervolume <= by_gradients.hypervolume);
    CHECK(by_population.hypervolume >= 0.98 * by_gradients.hypervolume);
    CHECK(by_population.stages_used == 1);
    CHECK(by_gradients.counters.evaluations * 4 < by_population.counters.evaluations);
  }
}

TEST_CASE("a front without a reference is measured from a tenth of its span beyond its worst",
          "[optim][pareto][closed_form]") {
  for (const auto& known : test::known_fronts(10)) {
    if (known.name != "BNH") continue;  // two objectives to minimize
    ParetoOptions options = options_for(known);
    options.reference.clear();
    options.points = 10;
    const Front front = pareto_front(known.problem, options);
    for (std::size_t k = 0; k < 2; ++k) {
      double low = HUGE_VAL, high = -HUGE_VAL;
      for (const auto& p : front.points) {
        low = std::min(low, p.evaluation.values[k]);
        high = std::max(high, p.evaluation.values[k]);
      }
      REQUIRE(high > low);
      CHECK(front.reference[k] == Approx(high + 0.1 * (high - low)).epsilon(1e-15));
    }
  }
}

TEST_CASE("a front without a feasible design says so", "[optim][pareto][infeasible]") {
  auto known = test::known_fronts(10);
  for (auto& k : known) {
    if (k.name != "BNH") continue;
    k.problem.constraints[0].upper = 1.0;   // within 1 of (5, 0)
    k.problem.constraints[1].lower = 60.0;  // and 7.7 away from (8, -3)
    const Front front = pareto_front(k.problem);
    CHECK(front.outcome == Outcome::infeasible);
    CHECK(front.points.empty());
    CHECK(front.infeasibility.conflict.size() == 2);
  }
}

TEST_CASE("prices say what a limit is worth to each objective while the other stays",
          "[optim][pareto][closed_form]") {
  // Squared distances from (0, 0) and (a, 0) under y >= b: the front is y = b, 0 < x < a. Lowering b
  // by d with one distance held moves x as well: the first gains 2 a b d / (a - x), the second
  // 2 a b d / x. The first is in other units, 1000 times smaller.
  const double a = 3;
  const double b = 0.5;
  const double unit = 1e-3;
  Problem p;
  p.variables = {{"x", -1, 5, 1}, {"y", -1, 5, 2}};
  p.objectives = {{"near"}, {"far"}};
  p.constraints = {{"height", b, std::numeric_limits<double>::infinity()}};
  p.evaluate = [a, unit](std::span<const double> v, bool) {
    Evaluation e;
    const double x = v[0];
    const double y = v[1];
    e.values = {unit * (x * x + y * y), (x - a) * (x - a) + y * y, y};
    e.jacobian = {2 * unit * x, 2 * unit * y, 2 * (x - a), 2 * y, 0, 1};
    return e;
  };
  for (const double x : {0.2, 1.0, 2.7}) {
    const Certificate c = certify(p, std::vector<double>{x, b});
    REQUIRE(c.passed);
    REQUIRE(c.prices.size() == 2);
    const double multiplier = c.limits[0].multiplier;
    // By hand, the rest is rounding of a least-squares solution of three unknowns.
    CHECK(multiplier / c.prices[0] == Approx(unit * 2 * a * b / (a - x)).epsilon(1e-9));
    CHECK(multiplier / c.prices[1] == Approx(2 * a * b / x).epsilon(1e-9));
    // Along the front the gradients' ratio is the rate of trade: unit x / (a - x).
    CHECK(c.prices[1] / c.prices[0] == Approx(unit * x / (a - x)).epsilon(1e-9));
  }
  CHECK(certify(p, std::vector<double>{0.0, b}).prices[1] == Approx(0).margin(1e-12));
}
