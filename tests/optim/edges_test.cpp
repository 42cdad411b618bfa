// SPDX-License-Identifier: Apache-2.0
// What ordinary problems do not ask for: many whole numbers, a global search, callers' mistakes.
#include "optim/bank/dual_problem.hpp"

#include <twum/base/error.hpp>
#include <twum/optim/hypervolume.hpp>
#include <twum/optim/latin_hypercube.hpp>
#include <twum/optim/least_squares.hpp>
#include <twum/optim/library_versions.hpp>
#include <twum/optim/low_discrepancy.hpp>
#include <twum/optim/pareto.hpp>
#include <twum/optim/solve.hpp>
#include <twum/optim/solvers.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <set>

using namespace twum;
using namespace twum::optim;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

using D = Dual<double, 4>;

constexpr double kCentres[] = {2.3, 6.8, 4.4, 0.3};

// Three whole numbers of ten values each and one real one, each with a parabola of its own: the best
// whole numbers are those next to the centres.
Problem whole_numbers() {
  Problem p;
  p.variables = test::box(4, 0.0, 9.0, {9.0, 0.0, 0.0, 5.0});
  for (std::size_t i = 0; i < 3; ++i) p.variables[i].integer = true;
  p.objectives = {{"f"}};
  p.evaluate = test::dual_evaluator<4>(1, [](const D* x, D* r) {
    r[0] = D(0.0);
    for (int i = 0; i < 4; ++i) r[0] = r[0] + (x[i] - kCentres[i]) * (x[i] - kCentres[i]);
  });
  return p;
}

// (x^2 - 1)^2 + 0.3 x + y^2: two valleys, the left one deeper.
Problem two_valleys() {
  Problem p;
  p.variables = test::box(2, -2.0, 2.0, {1.2, 0.5});
  p.objectives = {{"f"}};
  p.evaluate = test::dual_evaluator<4>(1, [](const D* x, D* r) {
    const D well = x[0] * x[0] - 1.0;
    r[0] = well * well + 0.3 * x[0] + x[1] * x[1];
  });
  return p;
}

// Zero of the slope 4 x (x^2 - 1) + 0.3 between two places, by bisection.
double slope_zero(double low, double high) {
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (4 * middle * (middle * middle - 1) + 0.3 < 0 ? low : high) = middle;
  }
  return low;
}

}  // namespace

TEST_CASE("an optimum on a bound is the bound to the last bit, on a logarithmic scale too",
          "[optim][identity]") {
  // Of these lower * exp(log(upper / lower)) falls short of upper in its last bits.
  const double bounds[][2] = {{1.867, 13.07}, {0.15, 4.51}, {0.036, 1.82}, {0.282, 14.1}};
  for (const auto& [lower, upper] : bounds) {
    for (const bool largest : {true, false}) {
      Problem p;
      p.variables = {{"x", lower, upper, std::sqrt(lower * upper), Scale::log}};
      p.objectives = {{"f"}};
      p.objectives[0].sense = largest ? Sense::maximize : Sense::minimize;
      p.evaluate = test::dual_evaluator<4>(1, [](const D* x, D* r) { r[0] = x[0]; });
      CHECK(solve(p, {}).design[0] == (largest ? upper : lower));
    }
  }
}

TEST_CASE("each stratum of each coordinate of a Latin hypercube holds one point", "[optim][lhs]") {
  for (const std::uint64_t count : {1U, 2U, 3U, 7U, 64U, 65U, 1000U}) {
    const LatinHypercube design(3, count, 5);
    CHECK(design.dimension() == 3);
    CHECK(design.count() == count);
    std::vector<std::set<std::uint64_t>> taken(3);
    std::vector<double> point(3);
    for (std::uint64_t i = 0; i < count; ++i) {
      design.point(i, point);
      for (std::size_t j = 0; j < 3; ++j) {
        const double place = point[j] * static_cast<double>(count);
        CHECK(static_cast<std::uint64_t>(place) == design.stratum(i, j));
        taken[j].insert(static_cast<std::uint64_t>(place));
      }
    }
    for (const auto& strata : taken)
      CHECK((strata.size() == count && *strata.rbegin() == count - 1));
  }
  CHECK_THROWS_WITH(LatinHypercube(0, 10, 1), Contains("dimension of 0"));
  CHECK_THROWS_AS(LatinHypercube(1, 0, 1), InputError);
  CHECK_THROWS_WITH(LatinHypercube(1, (std::uint64_t{1} << 30U) + 1, 1), Contains("2^30"));
}

TEST_CASE("more whole numbers than can be tried one by one are searched step by step",
          "[optim][integer]") {
  const Result r = solve(whole_numbers());
  REQUIRE(r.outcome == Outcome::optimal);
  CHECK(std::vector(r.design.begin(), r.design.begin() + 3) == std::vector{2.0, 7.0, 4.0});
  CHECK(std::abs(r.design[3] - kCentres[3]) < 1e-6);  // of a parabola, to the square root of 1e-12
}

TEST_CASE("whole numbers that a budget leaves untried are not called optimal", "[optim][integer]") {
  SolveOptions options;
  options.budget.evaluations = 60;  // a few of the thousand
  const Result r = solve(whole_numbers(), options);
  CHECK(r.outcome == Outcome::budget);
  CHECK(r.counters.evaluations <= 60);
  options = {};
  Problem few = whole_numbers();
  few.variables[1].upper = few.variables[1].lower;
  few.variables[2].upper = few.variables[2].lower;  // ten left: all of them are tried
  options.budget.evaluations = 60;
  CHECK(solve(few, options).outcome == Outcome::budget);
}

TEST_CASE("whole numbers may be wanted large, contradict each other, or lead nowhere",
          "[optim][integer]") {
  Problem p = whole_numbers();
  p.objectives[0].sense = Sense::maximize;
  p.evaluate = [down = p.evaluate](std::span<const double> x, bool gradient) {
    Evaluation e = down(x, gradient);
    for (double& v : e.values) v = -v;
    for (double& d : e.jacobian) d = -d;
    return e;
  };
  const Result top = solve(p);
  REQUIRE(top.outcome == Outcome::optimal);
  CHECK(std::vector(top.design.begin(), top.design.begin() + 3) == std::vector{2.0, 7.0, 4.0});

  p = whole_numbers();
  p.constraints = {{"sum", -kInfinity, 1.0}, {"least", 2.0, kInfinity}};
  p.evaluate = test::dual_evaluator<4>(3, [](const D* x, D* r) {
    r[0] = x[3] * x[3];
    r[1] = x[0] + x[1] + x[2];
    r[2] = x[0];
  });
  const Result never = solve(p);
  REQUIRE(never.outcome == Outcome::infeasible);
  CHECK_FALSE(never.certificate.passed);
  REQUIRE(never.infeasibility.relaxations.size() == 1);
  CHECK(never.infeasibility.relaxations[0].amount == Approx(1.0).epsilon(1e-6));
  REQUIRE(never.design.size() == 4);
  // The larger of the two violations, both in units of the same steps, is 1 at least.
  const double sum = never.design[0] + never.design[1] + never.design[2];
  CHECK(std::max(sum - 1.0, 2.0 - never.design[0]) == 1.0);

  p.evaluate = [](std::span<const double>, bool) { return Evaluation{{}, {}, {}, "torn"}; };
  const Result torn = solve(p);
  CHECK((torn.outcome == Outcome::failed || torn.outcome == Outcome::budget));
  CHECK(torn.counters.failures.at("torn") == torn.counters.evaluations);
}

TEST_CASE("a global search finds the deeper valley, which a start in the other one misses",
          "[optim][global]") {
  SolveOptions options;
  options.starts = 1;
  const Result near = solve(two_valleys(), options);
  REQUIRE(near.outcome == Outcome::optimal);
  CHECK(near.design[0] == Approx(slope_zero(0.5, 1.5)).epsilon(1e-6));
  options.global = "nlopt:isres";
  const Result deep = solve(two_valleys(), options);
  REQUIRE(deep.outcome == Outcome::optimal);
  CHECK(deep.design[0] == Approx(slope_zero(-1.5, -0.5)).epsilon(1e-6));
  CHECK(std::abs(deep.design[1]) < 1e-6);
  options.global = "nlopt:slsqp";
  CHECK_THROWS_WITH(solve(two_valleys(), options), Contains("does not search globally"));
}

TEST_CASE("solvers refuse options they cannot read", "[optim][error]") {
  const Problem p = two_valleys();
  SolveOptions options;
  options.solver = "nlopt:slsqp";
  for (const char* text : {"1e-3x", "-1", "", "nan"}) {
    options.solver_options = {{"xtol_rel", text}};
    CHECK_THROWS_WITH(solve(p, options), Contains("is not a number from"));
  }
  for (const char* name : {"population", "vector_storage", "inner_evaluations"}) {
    options.solver_options = {{name, "2.5"}};
    CHECK_THROWS_WITH(solve(p, options), Contains("'2.5' is not a whole number"));
  }
  if (find_solver("ipopt").available) {
    options.solver = "ipopt";
    options.solver_options = {{"mu_strategy", "hopeful"}};
    CHECK_THROWS_WITH(solve(p, options), Contains("is none of monotone|adaptive"));
    options.solver_options = {{"max_iter", "2.5"}};
    CHECK_THROWS_WITH(solve(p, options), Contains("'2.5' is not a whole number"));
    options.solver_options = {{"mu_strategy", "monotone"}, {"max_iter", "200"}};
    CHECK(solve(p, options).outcome == Outcome::optimal);
  }
}

TEST_CASE("an evaluator that gives too little is told so", "[optim][error]") {
  Problem p = two_valleys();
  const Evaluator right = p.evaluate;
  p.evaluate = [&](std::span<const double> x, bool gradient) {
    Evaluation e = right(x, gradient);
    e.values.push_back(1.0);
    return e;
  };
  CHECK_THROWS_WITH(solve(p), Contains("gave 2 values for 1 responses"));
  p.evaluate = [&](std::span<const double> x, bool gradient) {
    Evaluation e = right(x, gradient);
    e.jacobian.pop_back();
    return e;
  };
  CHECK_THROWS_WITH(solve(p), Contains("gave 1 derivatives where 2 were expected"));
}

TEST_CASE("what has no meaning is refused by number", "[optim][error]") {
  CHECK_THROWS_WITH(hypervolume({{1.0}}, std::vector<double>{2.0}), Contains("1 objectives"));
  CHECK_THROWS_WITH(sobol_points(0, 4, 1), Contains("dimension 0"));
  CHECK_THROWS_WITH(pareto_front(two_valleys(), ParetoOptions{}),
                    Contains("needs two or three objectives; the problem has 1"));
  Problem p = whole_numbers();
  p.objectives.push_back({"g"});
  p.evaluate = test::dual_evaluator<4>(2, [](const D* x, D* r) {
    r[0] = x[0] + x[1];
    r[1] = x[2] - x[0];
  });
  p.variables[0].integer = true;
  p.variables[0].lower = 1;
  p.variables[0].upper = 100;
  CHECK_THROWS_WITH(pareto_front(p, ParetoOptions{}), Contains("at most 64"));
  CHECK_THROWS_WITH(solve(p), Contains("has 2 objectives; a front needs pareto_front"));
}

TEST_CASE("each solver option and library says what it is", "[optim]") {
  std::set<std::string> names;
  for (const SolverOption& option : solver_options()) {
    CAPTURE(option.name);
    CHECK(names.insert(option.solver + " " + option.name).second);
    CHECK((option.type == "number" || option.type == "integer" || option.type == "text"));
    CHECK_FALSE(option.range().empty());
    CHECK_FALSE(option.text.empty());
  }
  CHECK(names.contains("nlopt xtol_rel"));
  const auto versions = library_versions();
  REQUIRE(versions.size() == 3);
  CHECK(versions[0].name == "NLopt");
  CHECK_THAT(versions[0].version, StartsWith("2."));  // the build asks for 2.7 or later
  CHECK((versions[1].version == "none") != find_solver("ipopt").available);
  CHECK((versions[2].version == "none") != least_squares_solvers().back().available);
}

TEST_CASE("a search that is given no start begins in the middle of each scale",
          "[optim][closed_form]") {
  Problem p = two_valleys();
  p.variables = {{"linear", -1.0, 3.0}, {"log", 1e-3, 1e5}};
  p.variables[1].scale = Scale::log;
  const std::vector<double> start = start_design(p);
  CHECK(start[0] == 1.0);
  CHECK(start[1] == Approx(10.0).epsilon(1e-15));  // two roots and a product
}

TEST_CASE("the answer is that of the best stage, whichever start it had", "[optim][definition]") {
  int second = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SolveOptions options;
    options.seed = seed;
    options.starts = 2;
    const Result r = solve(two_valleys(), options);
    REQUIRE_FALSE(r.stages.empty());
    double best = kInfinity;
    for (const StageReport& stage : r.stages) best = std::min(best, stage.objective);
    CAPTURE(seed, best);
    CHECK(r.evaluation.values[0] <= best + 1e-9);  // Newton steps may change the last digits
    second += r.stages.size() > 1 && r.stages[1].objective < r.stages[0].objective - 0.1;
  }
  CHECK(second >= 3);
}
