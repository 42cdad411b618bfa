// SPDX-License-Identifier: Apache-2.0
// What the parts of a front search promise, each from its definition, and how a front says that it
// ended.
#include "fronts/front_search.hpp"
#include "optim/bank/dual_problem.hpp"

#include <twum/optim/hypervolume.hpp>
#include <twum/optim/pareto.hpp>
#include <twum/optim/random.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace twum;
using namespace twum::optim;

namespace {

using D3 = Dual<double, 3>;

// Least at opposite corners; the units differ, and the second is to be large.
Problem two_valleys() {
  Problem p;
  p.variables = test::box(2, 0.0, 4.0, {3.0, 1.0});
  p.objectives = {{"near"}, {"value", Sense::maximize}};
  p.evaluate = test::dual_evaluator<3>(2, [](const D3* x, D3* r) {
    r[0] = 100.0 * ((x[0] - 1.0) * (x[0] - 1.0) + (x[1] - 1.0) * (x[1] - 1.0));
    r[1] = 5.0 - (x[0] - 3.0) * (x[0] - 3.0) - (x[1] - 2.0) * (x[1] - 2.0);
  });
  return p;
}

// A ray from the origin meets the plane once, in its own direction. The ends are unique.
Problem slanted_plane() {
  Problem p;
  p.variables = test::box(3, 0.0, 1.0, {0.5, 0.5, 0.5});
  p.objectives = {{"a"}, {"b"}, {"c"}};
  p.constraints = {{"floor", 1.0}};
  p.evaluate = test::dual_evaluator<3>(4, [](const D3* x, D3* r) {
    r[0] = x[0];
    r[1] = 3.0 * x[1];
    r[2] = 7.0 * x[2];
    r[3] = x[0] + 2.0 * x[1] + 4.0 * x[2];
  });
  return p;
}

std::vector<std::vector<double>> random_points(std::size_t count, std::size_t dimension,
                                               std::uint64_t seed) {
  Random random(seed, 0, 0);
  std::vector<std::vector<double>> points(count, std::vector<double>(dimension));
  for (auto& p : points)
    for (double& v : p) v = std::floor(8.0 * random.uniform());  // with ties and repetitions
  return points;
}

// A vector with something left behind its end, which nobody may look at.
std::vector<double> with_remains(std::vector<double> v, double remains) {
  v.push_back(remains);
  v.pop_back();
  return v;
}

struct Search {
  explicit Search(const Problem& p) : problem(p), front(problem, solve, options, deadline) {
    front.runner().scale();
  }
  Problem problem;
  SolveOptions solve;
  ParetoOptions options;
  Deadline deadline{kInfinity};
  FrontSearch front;
};

}  // namespace

TEST_CASE("what stays of a set of points is what no other dominates, once",
          "[optim][pareto][definition]") {
  for (const std::size_t dimension : {2U, 3U})
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const auto points = random_points(12, dimension, seed);
      std::vector<std::size_t> expected;
      for (std::size_t i = 0; i < points.size(); ++i) {
        bool stays = true;
        for (std::size_t j = 0; j < points.size(); ++j) {
          bool no_worse = true;
          for (std::size_t k = 0; k < dimension; ++k) no_worse &= points[j][k] <= points[i][k];
          if (no_worse && (points[j] != points[i] || j < i)) stays = false;
        }
        if (stays) expected.push_back(i);
      }
      CHECK(nondominated(points) == expected);
    }
}

TEST_CASE("the ends of a front are where its objectives are 0 and 1",
          "[optim][pareto][definition]") {
  Search two(two_valleys());
  REQUIRE(two.front.find_ends({two.front.runner().unit_start()}));
  REQUIRE(two.front.ends().size() == 2);
  CHECK(two.front.ends()[0].y == std::vector<double>{0.0, 1.0});
  CHECK(two.front.ends()[1].y == std::vector<double>{1.0, 0.0});
}

TEST_CASE("a pool gives the design that is nearest in normalized objectives",
          "[optim][pareto][definition]") {
  Search s(two_valleys());
  CHECK(s.front.from_pool({0.5, 0.5}).empty());
  Random random(5, 0, 0);
  std::vector<std::vector<double>> units, values;
  for (std::size_t i = 0; i < 40; ++i) {
    units.push_back({random.uniform(), random.uniform()});
    const auto e = s.problem.evaluate(std::vector<double>{4 * units[i][0], 4 * units[i][1]}, false);
    s.front.add_to_pool(units[i], e);
    values.push_back(e.values);
  }
  REQUIRE(s.front.find_ends({s.front.runner().unit_start()}));
  // The valleys are at (1, 1) and (3, 2): the objectives run from 0 to 500 and from 5 down to 0.
  for (const auto& at : {std::vector<double>{0.1, 0.8}, {0.9, 0.2}, {0.5, 0.5}, {0.0, 1.0}}) {
    const auto distance = [&](const std::vector<double>& v) {
      return std::hypot(v[0] / 500.0 - at[0], (5.0 - v[1]) / 5.0 - at[1]);
    };
    const auto nearest = std::min_element(
        values.begin(), values.end(), [&](auto& a, auto& b) { return distance(a) < distance(b); });
    // No two of these distances are so nearly equal that the ends' accuracy would tell.
    CHECK(s.front.from_pool(with_remains(at, std::nan(""))) ==
          units[static_cast<std::size_t>(nearest - values.begin())]);
  }
}

TEST_CASE("on a plane front the directions of three objectives are a full lattice",
          "[optim][pareto][closed_form]") {
  Search s(slanted_plane());
  s.options.points = GENERATE(4U, 6U, 8U);
  REQUIRE(s.front.find_ends({s.front.runner().unit_start()}));
  const auto found = three_objective_front(s.front, s.options);
  std::size_t h = 1;  // besides the lattice there are three ends, some of them also in it
  while ((h + 1) * (h + 2) / 2 + 3 < found.size()) ++h;
  std::size_t hit = 0;
  for (std::size_t i = 0; i <= h; ++i)
    for (std::size_t j = 0; i + j <= h; ++j) {
      const double a = static_cast<double>(i) / static_cast<double>(h);
      const double b = static_cast<double>(j) / static_cast<double>(h);
      hit += std::any_of(found.begin(), found.end(), [&](const Solved& p) {
        const double sum = p.y[0] + p.y[1] + p.y[2];
        // A zero of a direction is 1e-6, and spans differ by less than ten.
        return std::hypot(p.y[0] / sum - a, p.y[1] / sum - b) < 1e-5;
      });
    }
  CHECK(hit == (h + 1) * (h + 2) / 2);
  CHECK(hit >= s.options.points);
}

TEST_CASE("a front says why it ended", "[optim][pareto][budget]") {
  ParetoOptions options;
  options.points = 6;
  const Front whole = pareto_front(two_valleys(), options);
  CHECK(whole.outcome == Outcome::optimal);
  CHECK(whole.stop == StopReason::finished);

  options.solve.budget.evaluations = whole.counters.evaluations / 2;
  const Front half = pareto_front(two_valleys(), options);
  CHECK(half.outcome == Outcome::budget);
  CHECK(half.stop == StopReason::evaluations);

  // The first evaluation scales the problem; without a second nothing is known about the ends.
  options.solve.budget.evaluations = 1;
  const Front none = pareto_front(two_valleys(), options);
  CHECK(none.outcome == Outcome::budget);
  CHECK(none.stop == StopReason::evaluations);
  CHECK(none.points.empty());

  options.solve.budget.evaluations = 20000;
  std::stop_source source;
  options.solve.stop = source.get_token();
  std::size_t calls = 0;
  options.solve.observer = [&](const Observation&) {
    if (++calls == whole.counters.evaluations / 2) source.request_stop();
  };
  const Front stopped = pareto_front(two_valleys(), options);
  CHECK(stopped.outcome == Outcome::budget);
  CHECK(stopped.stop == StopReason::requested);
}

TEST_CASE("a front without a feasible design is infeasible whether or not it is explained",
          "[optim][pareto][infeasible]") {
  Problem p = slanted_plane();
  p.constraints[0].lower = 8.0;  // of at most 7
  ParetoOptions options;
  options.solve.analyse_infeasible = GENERATE(true, false);
  const Front front = pareto_front(p, options);
  CHECK(front.outcome == Outcome::infeasible);
  CHECK(front.stop == StopReason::finished);
  CHECK(front.infeasibility.relaxations.empty() == !options.solve.analyse_infeasible);
}

TEST_CASE("what neighbours agree in may differ between them: then nothing is predicted",
          "[optim][pareto][manufactured]") {
  // Between the ends, at x = 0 and x = 1, the bound holds z at 0 but for a bump in the middle.
  Problem p;
  p.variables = test::box(2, 0.0, 2.0, {0.4, 0.3});
  p.objectives = {{"left"}, {"right"}};
  p.evaluate = test::dual_evaluator<3>(2, [](const D3* x, D3* r) {
    const D3 away = (x[0] - 0.5) / 0.3;
    const D3 inside = std::abs(away.v) < 1.0 ? 1.0 - away * away : D3(0.0);
    const D3 miss = x[1] - (inside * inside * inside - 0.1);
    r[0] = x[0] * x[0] + 0.3 * miss * miss;
    r[1] = (x[0] - 1.0) * (x[0] - 1.0) + 0.3 * miss * miss;
  });
  Search s(p);
  REQUIRE(s.front.find_ends({s.front.runner().unit_start()}));
  const Solved &a = s.front.ends()[0], &b = s.front.ends()[1];
  REQUIRE(a.design[1] == 0.0);
  REQUIRE(b.design[1] == 0.0);
  CHECK_FALSE(s.front.scalarize_predicted({0.5, 0.5}, {1.0, 1.0}, a, b));
  const auto found = s.front.scalarize({0.5, 0.5}, {1.0, 1.0}, {{0.25, 0.0}}, true);
  REQUIRE(found);  // by symmetry x = 0.5, where z is 0.9; the solver stops at a gradient of 1e-3
  CHECK(found->design[1] == Approx(0.9).margin(1e-3));
}
