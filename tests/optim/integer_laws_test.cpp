// SPDX-License-Identifier: Apache-2.0
// Laws of the search among whole numbers: which of them are tried, what their calls are named, and
// which answer is taken where none is feasible.
#include "optim/bank/dual_problem.hpp"

#include <twum/optim/solve.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <stop_token>

using namespace twum;
using namespace twum::optim;

namespace {

using D = Dual<double, 3>;
using Design = std::vector<double>;

// The first variable is a whole number from 0 to `most`, the second one any number within 2 of 0.
Problem mixed(double most, double start, std::vector<Constraint> constraints,
              std::function<void(const D*, D*)> f) {
  Problem p;
  p.variables = {{"x", 0.0, most, 0.0}, {"y", -2.0, 2.0, start}};
  p.variables[0].integer = true;
  p.objectives = {{"f"}};
  p.constraints = std::move(constraints);
  p.evaluate = test::dual_evaluator<3>(p.responses(), std::move(f));
  return p;
}

std::set<Design> designs_seen(const Problem& p, SolveOptions options, Result& result) {
  std::set<Design> seen;
  options.observer = [&](const Observation& o) { seen.emplace(o.design.begin(), o.design.end()); };
  result = solve(p, options);
  return seen;
}

// The sum of the steps from the lowest corner, but for a deep hole in the highest.
Problem far_hole(double lowest) {
  Problem p;
  p.variables = test::box(2, lowest, lowest + 3.0, {lowest, lowest});
  for (Variable& v : p.variables) v.integer = true;
  p.objectives = {{"f"}};
  p.evaluate = [lowest](std::span<const double> x, bool) {
    const double sum = x[0] + x[1] - 2.0 * lowest;
    return Evaluation{{sum == 6.0 ? -5.0 : sum}, {1.0, 1.0}, {}, {}};
  };
  return p;
}

}  // namespace

TEST_CASE(
    "whether whole numbers are all tried depends on how many there are, not on where they lie",
    "[optim][integer][translation]") {
  // Each step from the lowest corner is uphill: only who tries all 16 finds the hole.
  for (const double lowest : {-53.0, -3.0, 0.0, 5.0, 50.0}) {
    CAPTURE(lowest);
    Result r;
    CHECK(designs_seen(far_hole(lowest), {}, r).size() == 16);
    CHECK(r.outcome == Outcome::optimal);
    CHECK(r.design == Design{lowest + 3.0, lowest + 3.0});
  }
  // Of 19^3 only the start and its six neighbours are, where the start is the lowest place.
  Problem p;
  p.variables = test::box(3, -9.0, 9.0, {0.0, 0.0, 0.0});
  for (Variable& v : p.variables) v.integer = true;
  p.objectives = {{"f"}};
  p.evaluate = test::dual_evaluator<3>(
      1, [](const D* x, D* r) { r[0] = x[0] * x[0] + x[1] * x[1] + x[2] * x[2]; });
  Result r;
  CHECK(designs_seen(p, {}, r).size() == 7);
  CHECK(r.design == Design{0.0, 0.0, 0.0});
}

TEST_CASE("with whole numbers too a stage and an index name one call, and the next stages are free",
          "[optim][integer][definition]") {
  // Six combinations, each with a search of its own in the other variable.
  const Problem p = mixed(5.0, 0.5, {}, [](const D* x, D* r) {
    r[0] = (x[0] - 2.2) * (x[0] - 2.2) + (x[1] - 0.3) * (x[1] - 0.3) + 0.1 * x[0] * x[1];
  });
  std::uint64_t used = 0;
  for (const std::uint64_t first : {0U, 5U}) {
    std::set<std::pair<std::uint64_t, std::uint64_t>> names;
    SolveOptions options;
    options.first_stage = first;
    options.observer = [&](const Observation& o) { names.emplace(o.stage, o.index); };
    const Result r = solve(p, options);
    CAPTURE(first);
    CHECK(r.outcome == Outcome::optimal);
    CHECK(names.size() == r.counters.evaluations);
    CHECK(names.begin()->first == first);
    CHECK(names.rbegin()->first < first + r.stages_used);
    if (first > 0) CHECK(r.stages_used == used);
    used = r.stages_used;
  }
}

TEST_CASE("the least infeasible whole number has the smallest of the largest violations",
          "[optim][integer][closed_form]") {
  // x >= 7 and 3 x <= 3, whose slopes over the box are 5 and 15: in units of these the violations are
  // (7 - x) / 5 and (x - 1) / 5, which are equal at 4. In the constraints' own units they would be
  // 7 - x and 3 x - 3, which makes 2 the best; the objective would have 0.
  const Problem p =
      mixed(5.0, 0.5, {{"high", 7.0}, {"low", -kInfinity, 3.0}}, [](const D* x, D* r) {
        r[0] = x[0] + x[1] * x[1];
        r[1] = x[0];
        r[2] = 3.0 * x[0];
      });
  SolveOptions options;
  options.starts = 1;
  const Result r = solve(p, options);
  CHECK(r.outcome == Outcome::infeasible);
  REQUIRE(r.design.size() == 2);
  CHECK(r.design[0] == 4.0);
}

TEST_CASE("what the search for an explanation finds feasible is no longer called infeasible",
          "[optim][integer][infeasible]") {
  // y^3 - y = 0.5 - 0.1 x has one solution for either x, as 0.4 and 0.5 lie above the hump of
  // 2 / sqrt(27). The start lies behind the valley, and a search in steps as coarse as these ends far
  // from the curve.
  const Problem p = mixed(1.0, 0.7, {{"curve", 0.5, 0.5}}, [](const D* x, D* r) {
    r[0] = x[0] + x[1];
    r[1] = x[1] * x[1] * x[1] - x[1] + 0.1 * x[0];
  });
  for (const char* coarse : {"0.3", "1"}) {
    SolveOptions options;
    options.solver = "nlopt:cobyla";
    options.polish = false;
    options.solver_options = {{"xtol_rel", coarse}};
    CAPTURE(coarse);
    options.analyse_infeasible = false;
    REQUIRE(solve(p, options).outcome == Outcome::infeasible);
    options.analyse_infeasible = true;
    const Result r = solve(p, options);
    CHECK(r.outcome == Outcome::optimal);
    CHECK(r.infeasibility.relaxations.empty());
    REQUIRE(r.design.size() == 2);
    CHECK((r.design[0] == 0.0 || r.design[0] == 1.0));
    // A violation of 1e-8 in units of the slope over the box, 4 * 0.47 at the start, is 2e-8.
    const double y = r.design[1];
    CHECK(std::abs(y * y * y - y + 0.1 * r.design[0] - 0.5) < 2e-8);
  }
}

TEST_CASE("a search whose budget ends within a combination is not done with it",
          "[optim][integer][budget]") {
  // The better one of two whole numbers comes last, and its valley is bent.
  const Problem p = mixed(1.0, -1.2, {}, [](const D* x, D* r) {
    const D bend = x[1] * x[1] - 1.0, rest = 1.0 - x[1];
    r[0] = 1.0 - x[0] + 100.0 * x[0] * bend * bend + rest * rest;
  });
  const Result whole = solve(p);
  REQUIRE(whole.outcome == Outcome::optimal);
  REQUIRE(whole.design[0] == 1.0);
  int cut = 0;
  for (std::size_t budget = 1; budget < whole.counters.evaluations; ++budget) {
    SolveOptions options;
    options.budget.evaluations = budget;
    const Result r = solve(p, options);
    CAPTURE(budget, r.evaluation.values);
    if (r.outcome == Outcome::optimal) {
      CHECK(r.design[0] == 1.0);
      continue;
    }
    CHECK(r.outcome == Outcome::budget);
    CHECK(r.stop == StopReason::evaluations);
    ++cut;
  }
  CHECK(cut > 5);
}

TEST_CASE("a search among whole numbers that may not begin says so", "[optim][integer][budget]") {
  std::stop_source source;
  source.request_stop();
  SolveOptions options;
  options.stop = source.get_token();
  // Few enough to be tried one by one, many, and none that is whole.
  for (const double most : {1.0, 1000.0, 0.5}) {
    Problem p = mixed(most, 0.0, {}, [](const D* x, D* r) { r[0] = x[0] + x[1]; });
    p.variables[0].integer = most != 0.5;
    const Result r = solve(p, options);
    CAPTURE(most);
    CHECK(r.outcome == Outcome::budget);
    CHECK(r.stop == StopReason::requested);
    CHECK(r.counters.evaluations == 0);
    CHECK_FALSE(r.certificate.passed);
    CHECK(r.certificate.reason == "stopped before the test was done");
  }
}
