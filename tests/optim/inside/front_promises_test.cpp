// SPDX-License-Identifier: Apache-2.0
// What a front spends, how many points it has, and why it ended.
#include "fronts/front_search.hpp"
#include "optim/bank/dual_problem.hpp"

#include <twum/optim/pareto.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <map>

using namespace twum;
using namespace twum::optim;

namespace {

using D3 = Dual<double, 3>;

// Squared distances from the unit vectors.
Problem corners(std::size_t objectives) {
  Problem p;
  p.variables = test::box(3, 0.0, 1.0, {0.5, 0.5, 0.5});
  for (std::size_t k = 0; k < objectives; ++k) p.objectives.push_back({test::numbered('f', k)});
  p.evaluate = test::dual_evaluator<3>(objectives, [objectives](const D3* x, D3* r) {
    for (std::size_t k = 0; k < objectives; ++k) {
      r[k] = D3(0.0);
      for (std::size_t j = 0; j < 3; ++j) {
        const D3 d = x[j] - (j == k ? 1.0 : 0.0);
        r[k] = r[k] + d * d;
      }
    }
  });
  return p;
}

}  // namespace

TEST_CASE("a stop while a population searches is the reason that a front gives",
          "[optim][pareto][budget]") {
  ParetoOptions options;
  options.points = 4;
  options.population_evaluations = 1000;
  std::stop_source source;
  options.solve.stop = source.get_token();
  std::size_t calls = 0;
  options.solve.observer = [&](const Observation&) {
    if (++calls == 300) source.request_stop();
  };
  const Front front = pareto_front(corners(2), options);
  CHECK(front.outcome == Outcome::budget);
  CHECK(front.stop == StopReason::requested);
}

TEST_CASE("a population spends what it is given in whole generations, one at least",
          "[optim][pareto][budget]") {
  for (const std::size_t given : {1U, 100U, 199U, 1000U}) {
    ParetoOptions options;
    options.points = 4;
    options.population_evaluations = given;
    std::size_t calls = 0;
    options.solve.observer = [&](const Observation& o) { calls += o.stage == 1 ? 1U : 0U; };
    pareto_front(corners(2), options);
    // A child that is no other than its parent costs nothing.
    const std::size_t most = std::max<std::size_t>(given / 100, 1) * 100;
    CHECK(calls <= most);
    CHECK(calls > most - 100);
  }
}

TEST_CASE("a front has no more points than asked for", "[optim][pareto]") {
  for (const std::size_t objectives : {2U, 3U}) {
    ParetoOptions options;
    options.points = 1;
    CHECK(pareto_front(corners(objectives), options).points.size() == 1);
  }
}

TEST_CASE("a front of fixed variables is one point", "[optim][pareto][closed_form]") {
  for (const std::size_t objectives : {2U, 3U}) {
    Problem p = corners(objectives);
    for (Variable& v : p.variables) v.lower = v.upper = 0.5;
    Front front;
    REQUIRE_NOTHROW(front = pareto_front(p));
    CHECK(front.outcome == Outcome::optimal);
    CHECK(front.points.size() == 1);
  }
}

TEST_CASE("kicks go on after a success until as many as asked for fail in a row",
          "[optim][pareto][definition]") {
  Problem p;
  p.variables = test::box(1, -10.0, 10.0, {9.3});
  p.objectives = {{"valleys"}, {"far"}};
  p.evaluate = test::dual_evaluator<3>(2, [](const D3* x, D3* r) {
    r[0] = x[0] * x[0] / 100.0 - cos(6.0 * x[0]);
    r[1] = (x[0] - 20.0) * (x[0] - 20.0);
  });
  int kicked = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    std::map<std::uint64_t, double> least;
    SolveOptions solve;
    solve.seed = seed;
    solve.observer = [&](const Observation& o) {
      auto& value = least.try_emplace(o.stage, kInfinity).first->second;
      value = std::min(value, o.evaluation.values[0]);
    };
    ParetoOptions options;
    options.hops = 1;
    const Deadline deadline(kInfinity);
    FrontSearch search(p, solve, options, deadline);
    search.runner().scale();
    search.find_ends({{0.965}, {0.9}});
    // Stage 0 scales, 1 and 2 start, 3 is the first kick. After a success there has to be another.
    const double before = std::min(least[1], least[2]);
    // The lowest valleys lie (2 pi / 6)^2 / 100 = 0.011 apart in value; a search ends within rounding of one.
    if (least[3] >= before - 1e-3) continue;
    ++kicked;
    INFO("seed " << seed << ": " << before << ", kicked to " << least[3]);
    REQUIRE(least.contains(4));
    CHECK(std::abs(least[4] - least[3]) > 1e-9);  // a kick, not the second objective at the same
  }
  CHECK(kicked > 0);
}
