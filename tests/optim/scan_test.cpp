// SPDX-License-Identifier: Apache-2.0
// The look for a better valley once the searches have ended.
#include "optim/bank/dual_problem.hpp"

#include <twum/optim/low_discrepancy.hpp>
#include <twum/optim/scan.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

using namespace twum;
using namespace twum::optim;

namespace {

using D = Dual<double, 2>;

// A wide valley at 0.2, and beside it a narrow and deeper one at 0.9: 1 + 0.1 (x - 0.2)^2 - exp(-((x - 0.9) / 0.02)^2).
Problem two_valleys(double sign = 1) {
  Problem p;
  p.variables = test::box(1, 0.0, 1.0, {0.15});
  p.objectives = {{"f", sign > 0 ? Sense::minimize : Sense::maximize}};
  p.evaluate = test::dual_evaluator<2>(1, [sign](const D* x, D* r) {
    const D t = (x[0] - 0.9) / 0.02;
    r[0] = sign * (1.0 + 0.1 * (x[0] - 0.2) * (x[0] - 0.2) - exp(-1.0 * t * t));
  });
  return p;
}

SolveOptions local_search() {
  SolveOptions options;
  options.starts = 1;
  return options;
}

Result looked(const Problem& problem, const SolveOptions& options) {
  return look_further(problem, options, solve(problem, options));
}

}  // namespace

TEST_CASE("a valley that the searches missed is found from the sample", "[optim][scan]") {
  for (const double sign : {1.0, -1.0}) {
    const Problem problem = two_valleys(sign);
    const SolveOptions options = local_search();
    const Result local = solve(problem, options);
    REQUIRE(local.outcome == Outcome::optimal);
    CHECK(local.design[0] == Approx(0.2).margin(1e-5));
    const Result result = look_further(problem, options, local);
    CHECK(result.outcome == Outcome::optimal);
    // The slope 0.2 * 0.7 of the wide valley moves the deep one by 0.14 * 0.02^2 / 2 = 2.8e-5, and 0.1 * 0.7^2 lifts it.
    CHECK(result.design[0] == Approx(0.9 - 2.8e-5).margin(1e-6));
    CHECK(sign * result.evaluation.values[0] == Approx(0.049).epsilon(1e-4));
    CHECK(result.scan.before == Approx(sign).epsilon(1e-9));
    CHECK(result.scan.replaced);
    CHECK(result.scan.designs == 512);
    CHECK(result.scan.feasible == 512);
    // Lower than 1 where exp(-t^2) > 0.049, thus |t| < 1.737, or 6.95 % of the range; each 512th of it holds one point.
    CHECK(std::abs(static_cast<double>(result.scan.better) - 0.0695 * 512) <= 2);
    CHECK(result.counters.evaluations > local.counters.evaluations + 512);
    CHECK(result.stages.size() > local.stages.size());
  }
}

TEST_CASE("of one valley no sample is better, and the answer stays as it is", "[optim][scan]") {
  Problem problem = two_valleys();
  problem.variables[0].upper = 0.6;
  problem.constraints = {{"g", -kInfinity, 0.3}};
  problem.evaluate = test::dual_evaluator<2>(2, [](const D* x, D* r) {
    r[0] = 1.0 + (x[0] - 0.2) * (x[0] - 0.2);
    r[1] = x[0];
  });
  const SolveOptions options = local_search();
  const Result local = solve(problem, options);
  const Result result = look_further(problem, options, local);
  CHECK(result.outcome == Outcome::optimal);
  CHECK(result.design == local.design);
  CHECK(result.scan.better == 0);
  CHECK_FALSE(result.scan.replaced);
  // Half of the range keeps the limit.
  CHECK(std::abs(static_cast<double>(result.scan.feasible) - 256) <= 1);
  CHECK(result.counters.evaluations == local.counters.evaluations + 512);
  CHECK(result.stages.size() == local.stages.size());  // no search began at a sample
}

// Many valleys, so that each of the four best samples without a better one nearby has one of its own.
TEST_CASE("threads change neither the look for better valleys nor its evaluations",
          "[optim][scan][determinism]") {
  Problem problem;
  problem.variables = test::box(2, 0.0, 1.0, {0.1, 0.1});
  problem.objectives = {{"f"}};
  problem.evaluate = test::dual_evaluator<2>(1, [](const D* x, D* r) {
    r[0] = sin(25.0 * x[0]) * sin(25.0 * x[1]) + 0.1 * (x[0] + x[1]);
  });
  const auto run = [&](std::size_t threads) {
    std::map<std::pair<std::uint64_t, std::uint64_t>, std::vector<double>> seen;
    SolveOptions options;
    options.starts = 2;
    options.jobs = threads;
    options.observer = [&](const Observation& o) {
      CHECK(seen.emplace(std::pair{o.stage, o.index},
                         std::vector<double>(o.design.begin(), o.design.end()))
                .second);
    };
    const Result local = solve(problem, options);
    const Result r = look_further(problem, options, local);
    CHECK(r.scan.designs == 512);
    CHECK(r.counters.evaluations == seen.size());
    CHECK(r.stages.size() > local.stages.size());
    return std::tuple{r.design, r.counters.evaluations, seen};
  };
  const auto one = run(1);
  CHECK(run(2) == one);
  CHECK(run(5) == one);
}

TEST_CASE("the sample takes what is left of the budget", "[optim][scan]") {
  const Problem problem = two_valleys();
  SolveOptions options = local_search();
  const std::size_t used = solve(problem, options).counters.evaluations;
  options.budget.evaluations = used + 100;
  const Result some = looked(problem, options);
  CHECK(some.scan.designs == 100);
  // One in fifteen is better, but nothing is left to go on from there: the design is no longer called an optimum.
  CHECK(some.scan.better > 0);
  CHECK_FALSE(some.scan.replaced);
  CHECK(some.outcome == Outcome::feasible);
  options.scan = 0;
  CHECK(looked(problem, options).scan.designs == 0);
  CHECK(looked(problem, options).outcome == Outcome::optimal);
}

TEST_CASE("without a feasible design there is nothing to compare with", "[optim][scan]") {
  Problem problem = two_valleys();
  problem.constraints = {{"g", 2.0, kInfinity}};
  problem.evaluate = test::dual_evaluator<2>(2, [](const D* x, D* r) {
    r[0] = x[0];
    r[1] = x[0];
  });
  const Result result = looked(problem, local_search());
  CHECK(result.outcome == Outcome::infeasible);
  CHECK(result.scan.designs == 0);
}

TEST_CASE("designs that fail are sampled and not counted as feasible", "[optim][scan]") {
  Problem problem = two_valleys();
  problem.evaluate = [inner = problem.evaluate](std::span<const double> x, bool gradient) {
    Evaluation e = inner(x, gradient);
    if (x[0] >= 0.5) e = {{}, {}, {}, "beyond"};
    return e;
  };
  const SolveOptions options = local_search();
  const Result local = solve(problem, options);
  const auto failed = [](const Result& r) { return r.counters.failed(); };
  const Result result = look_further(problem, options, local);
  CHECK(result.scan.designs == 512);
  CHECK(std::abs(static_cast<double>(result.scan.feasible) - 256) <= 1);
  CHECK(failed(result) - failed(local) == 512 - result.scan.feasible);
}

TEST_CASE("a stop request ends the look, and what was found stays", "[optim][scan]") {
  const Problem problem = two_valleys();
  SolveOptions options = local_search();
  const Result local = solve(problem, options);
  std::stop_source source;
  options.stop = source.get_token();
  std::size_t seen = 0;
  options.observer = [&](const Observation&) {
    if (++seen == 7) source.request_stop();
  };
  const Result result = look_further(problem, options, local);
  CHECK(result.stop == StopReason::requested);
  CHECK(result.scan.designs <= 8);
  CHECK(result.design == local.design);
}

TEST_CASE("a search that looked goes the same way once more", "[optim][scan]") {
  const Problem problem = two_valleys();
  const auto way = [&] {
    std::map<std::pair<std::uint64_t, std::uint64_t>, double> designs;
    SolveOptions options = local_search();
    options.observer = [&](const Observation& o) {
      // Stage and index identify an evaluation permanently.
      CHECK(designs.emplace(std::pair{o.stage, o.index}, o.design[0]).second);
    };
    looked(problem, options);
    return designs;
  };
  CHECK(way() == way());
}

TEST_CASE("whole numbers have equal parts of the sample, scales are kept", "[optim][scan]") {
  Problem problem = two_valleys();
  problem.variables = test::box(2, 1.0, 100.0);
  problem.variables[0].integer = true;
  problem.variables[0].lower = 2.5;
  problem.variables[0].upper = 6.9;
  problem.variables[1].scale = Scale::log;
  std::map<double, int> count;
  int below = 0;
  for (const auto& unit : sobol_points(2, 512, 3)) {
    const std::vector<double> design = design_at(problem, unit);
    ++count[design[0]];
    below += design[1] < 10.0;
  }
  // 3, 4, 5 and 6: a quarter each, and by ratio half of 1 to 100 is below 10; Sobol points fill such parts evenly.
  REQUIRE(count.size() == 4);
  for (const auto& [value, times] : count) {
    CHECK((value >= 3 && value <= 6));
    CHECK(std::abs(times - 128) <= 1);
  }
  CHECK(std::abs(below - 256) <= 1);
}

namespace {

// (x^2 - 4)^2 / 16 + x / 4 has two valleys, which end where x^3 - 4 x + 1 = 0.
Problem violated_in_two_valleys(double most) {
  Problem p;
  p.variables = test::box(1, -4.0, 4.0, {2.5});
  p.objectives = {{"f", Sense::minimize}};
  p.constraints = {{"c", -kInfinity, most}};
  p.evaluate = test::dual_evaluator<2>(2, [](const D* x, D* r) {
    const D t = x[0] * x[0] - 4.0;
    r[0] = (x[0] - 3.0) * (x[0] - 3.0);
    r[1] = t * t / 16.0 + x[0] / 4.0;
  });
  return p;
}

double lowest() {
  double x = -2.1;
  for (int i = 0; i < 20; ++i) x -= (x * x * x - 4 * x + 1) / (3 * x * x - 4);
  return (x * x - 4) * (x * x - 4) / 16 + x / 4;
}

}  // namespace

TEST_CASE("a feasible valley far from the only start is found", "[optim][scan]") {
  const Result result = solve(violated_in_two_valleys(-0.4), local_search());
  REQUIRE(result.outcome == Outcome::optimal);
  // The right end of the valley, towards the goal.
  CHECK(result.design[0] < -1.5);
  CHECK(result.evaluation.values[1] == Approx(-0.4).epsilon(1e-8));
}

TEST_CASE("without a feasible design the least violation is that of the lower valley",
          "[optim][scan][infeasible]") {
  const Result result = solve(violated_in_two_valleys(-1), local_search());
  REQUIRE(result.outcome == Outcome::infeasible);
  REQUIRE(result.infeasibility.relaxations.size() == 1);
  // The search ends where the slope is below 1e-6 of its scale, the value to the square of that.
  CHECK(result.infeasibility.relaxations[0].amount == Approx(lowest() + 1).epsilon(1e-7));
}

TEST_CASE("a valley without a sample below the answer is found from its slope", "[optim][scan]") {
  // A hollow at 0.9, above the other valley but for a needle in its lowest place that no sample meets.
  Problem p;
  p.variables = test::box(1, 0.0, 1.0, {0.15});
  p.objectives = {{"f", Sense::minimize}};
  p.evaluate = test::dual_evaluator<2>(1, [](const D* x, D* r) {
    const D hollow = (x[0] - 0.90258) / 0.03, needle = (x[0] - 0.901) / 0.0008;
    r[0] = 1.0 + (x[0] - 0.2) * (x[0] - 0.2) - 0.4 * exp(-1.0 * hollow * hollow) -
           0.12 * exp(-1.0 * needle * needle);
  });
  SolveOptions options;
  options.starts = 3;  // none of them is near
  const Result first = solve(p, options);
  REQUIRE(first.evaluation.values[0] == Approx(1).epsilon(1e-4));
  const Result result = look_further(p, options, first);
  CHECK(result.scan.better == 0);
  CHECK(result.scan.replaced);
  // The hollow is level there; the needle's own curvature, 4e5, keeps the rest within 1e-6 of its place.
  CHECK(result.design[0] == Approx(0.901).margin(1e-4));
  CHECK(result.outcome == Outcome::optimal);
}
