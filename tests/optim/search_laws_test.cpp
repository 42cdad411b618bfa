// SPDX-License-Identifier: Apache-2.0
// Laws of a whole solve: what each call is named, which solvers have their turn, how whole numbers
// are searched, and what is said of an answer.
#include "optim/bank/dual_problem.hpp"

#include <twum/optim/pareto.hpp>
#include <twum/optim/solve.hpp>
#include <twum/optim/solvers.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <map>
#include <set>

using namespace twum;
using namespace twum::optim;

namespace {

using D = Dual<double, 3>;

Problem bowl(std::size_t n, std::vector<double> start, double aim) {
  Problem p;
  p.variables = test::box(n, -2.0, 2.0, start);
  p.objectives = {{"f"}};
  p.evaluate = test::dual_evaluator<3>(1, [n, aim](const D* x, D* r) {
    r[0] = D(0.0);
    for (std::size_t i = 0; i < n; ++i) r[0] = r[0] + (x[i] - aim) * (x[i] - aim);
  });
  return p;
}

// (x^2 - 1)^2 + 0.3 x + y^2: two valleys, the left one deeper, the start in the other.
Problem two_valleys() {
  Problem p;
  p.variables = test::box(2, -2.0, 2.0, {1.2, 0.5});
  p.objectives = {{"f"}};
  p.evaluate = test::dual_evaluator<3>(1, [](const D* x, D* r) {
    const D well = x[0] * x[0] - 1.0;
    r[0] = well * well + 0.3 * x[0] + x[1] * x[1];
  });
  return p;
}

// x + y >= 3 and x^2 + y^2 <= 1 cannot both hold.
Problem contradiction() {
  Problem p = bowl(2, {1.0, 1.0}, 0.0);
  p.constraints = {{"sum", 3.0}, {"circle", -kInfinity, 1.0}};
  p.evaluate = test::dual_evaluator<3>(3, [](const D* x, D* r) {
    r[0] = x[0] * x[0];
    r[1] = x[0] + x[1];
    r[2] = x[0] * x[0] + x[1] * x[1];
  });
  return p;
}

// Whole numbers from 0 to `most` pulled towards `aims`.
Problem wholes(std::vector<double> aims, double most, std::vector<double> start) {
  Problem p;
  p.variables = test::box(aims.size(), 0.0, most, start);
  for (Variable& v : p.variables) v.integer = true;
  p.objectives = {{"f"}};
  p.evaluate = test::dual_evaluator<3>(1, [aims](const D* x, D* r) {
    r[0] = D(0.0);
    for (std::size_t i = 0; i < aims.size(); ++i) r[0] = r[0] + (x[i] - aims[i]) * (x[i] - aims[i]);
  });
  return p;
}

std::vector<std::string> solvers_of(const Result& r) {
  std::vector<std::string> names;
  for (const StageReport& s : r.stages) names.push_back(s.solver);
  return names;
}

// Designs by (stage, index).
using Log = std::map<std::pair<std::uint64_t, std::uint64_t>, std::vector<double>>;

Observer into(Log& log, bool& twice) {
  return [&](const Observation& o) {
    const auto at = std::pair{o.stage, o.index};
    twice = twice || log.contains(at);
    log[at].assign(o.design.begin(), o.design.end());
  };
}

}  // namespace

TEST_CASE("a stage and an index name one call, and the next solve's stages are free",
          "[optim][definition]") {
  for (const std::uint64_t first : {0U, 7U}) {
    Log log;
    bool twice = false;
    SolveOptions options;
    if (first > 0) options.first_stage = first;
    options.observer = into(log, twice);
    const Result r = solve(two_valleys(), options);
    CHECK_FALSE(twice);
    CHECK(log.size() == r.counters.evaluations);
    CHECK(log.begin()->first.first == first);
    CHECK(log.rbegin()->first.first < first + r.stages_used);
  }
  Problem p = bowl(2, {1.0, 1.0}, 0.0);
  p.objectives = {{"f"}, {"g"}};
  p.evaluate = test::dual_evaluator<3>(2, [](const D* x, D* r) {
    r[0] = x[0] * x[0] + x[1] * x[1];
    r[1] = (x[0] - 1.0) * (x[0] - 1.0) + x[1] * x[1];
  });
  for (const std::size_t population : {0U, 300U}) {
    Log log;
    bool twice = false;
    ParetoOptions options;
    options.points = 5;
    options.population_evaluations = population;
    options.solve.observer = into(log, twice);
    const Front front = pareto_front(p, options);
    CHECK_FALSE(twice);
    CHECK(log.size() == front.counters.evaluations);
  }
}

TEST_CASE("a stage of its own has random numbers of its own", "[optim][global]") {
  std::set<std::vector<double>> first;
  const std::uint64_t stages[] = {0, 1, 2, 3000000, 4000000};
  for (const std::uint64_t stage : stages) {
    Log log;
    bool twice = false;
    SolveOptions options;
    options.solver = "nlopt:crs2_lm";
    options.budget.evaluations = 60;
    options.first_stage = stage;
    options.observer = into(log, twice);
    solve(two_valleys(), options);
    first.insert(log.at({stage + 1, 1}));  // behind the start
  }
  CHECK(first.size() == std::size(stages));
}

TEST_CASE("a lone variable whose start cannot be evaluated is scaled elsewhere", "[optim]") {
  for (const std::size_t n : {1U, 2U}) {
    Problem p = bowl(n, std::vector<double>(n, 1.5), 0.5);
    p.evaluate = [right = p.evaluate](std::span<const double> x, bool gradient) {
      return x[0] > 1.4 ? Evaluation{{}, {}, {}, "torn"} : right(x, gradient);
    };
    const Result r = solve(p);
    CHECK(r.outcome == Outcome::optimal);
    CHECK(std::abs(r.design[0] - 0.5) < 1e-6);  // of a parabola, to the square root of 1e-12
  }
}

TEST_CASE("an optimum found is not looked for again, and nothing is said of what did not happen",
          "[optim][definition]") {
  SolveOptions options;
  options.solver = "nlopt:slsqp";
  const Result r = solve(bowl(2, {1.0, -1.0}, 0.5), options);
  REQUIRE(r.outcome == Outcome::optimal);
  CHECK(r.stop == StopReason::finished);
  CHECK(solvers_of(r) == std::vector<std::string>{"nlopt:slsqp"});
  CHECK(r.infeasibility.relaxations.empty());
  CHECK_FALSE(r.infeasibility.certified);
}

TEST_CASE("the best of several starts is the answer", "[optim]") {
  const Result r = solve(two_valleys());
  REQUIRE(r.outcome == Outcome::optimal);
  CHECK(r.design[0] < 0.0);
}

TEST_CASE("searches that agree spare the others, and one start is one search",
          "[optim][definition]") {
  // Rosenbrock's valley is curved, so other starts are worth a search, and has one optimum.
  Problem bent;
  bent.variables = {{"x", -10.0, 10.0, -1.2}, {"y", -10.0, 10.0, 1.0}};
  bent.objectives = {{"f"}};
  bent.evaluate = [](std::span<const double> x, bool) {
    const double bend = x[1] - x[0] * x[0];
    Evaluation e;
    e.values = {100.0 * bend * bend + (1.0 - x[0]) * (1.0 - x[0])};
    e.jacobian = {-400.0 * bend * x[0] - 2.0 * (1.0 - x[0]), 200.0 * bend};
    return e;
  };
  const Result agreed = solve(bent), divided = solve(two_valleys());
  CHECK(agreed.outcome == Outcome::optimal);
  CHECK(agreed.stages.size() == 5);  // the first search, and the first half of seven others
  CHECK(std::ranges::count(agreed.stages, std::string("KNOWN_OPTIMUM"), &StageReport::word) == 4);
  CHECK(divided.stages.size() >= 8);
  SolveOptions one;
  one.starts = 1;
  CHECK(solve(bent, one).stages.size() == 1);
}

TEST_CASE("Newton steps finish a crude answer, but only where they may", "[optim]") {
  SolveOptions options;
  options.solver = "nlopt:direct";
  options.budget.evaluations = 400;  // boxes of 3^-4 or so
  const Problem p = bowl(2, {1.0, -1.0}, 0.35);
  options.polish = false;
  const Result crude = solve(p, options);
  CHECK_FALSE(crude.certificate.passed);
  options.polish = true;
  const Result fine = solve(p, options);
  CHECK(fine.certificate.passed);
  // Curvature 2 and a stationarity of 1e-6 relative to the slope at the start, about one.
  CHECK(std::abs(fine.design[0] - 0.35) < 1e-6);
}

TEST_CASE("a global search leaves half of the budget", "[optim][global]") {
  SolveOptions options;
  options.global = "nlopt:isres";
  options.budget.evaluations = 2001;
  const Result r = solve(two_valleys(), options);
  REQUIRE(solvers_of(r).front() == "nlopt:isres");
  // The start was looked at before; of the other 2000 it gets half and needs it all, as no
  // tolerance of 1e-11 is met by 1000 random designs.
  CHECK(r.stages.front().evaluations == 1000);
}

TEST_CASE("each rung of the ladder has its turn until one is certified", "[optim]") {
  const bool has_ipopt = find_solver("ipopt").available;
  std::vector<std::string> ladder{"nlopt:slsqp", "nlopt:slsqp"};
  if (has_ipopt) ladder.insert(ladder.end(), {"ipopt", "ipopt"});  // the second one from the start
  SolveOptions options;
  options.starts = 1;
  const auto never = solvers_of(solve(contradiction(), options));
  REQUIRE(never.size() > ladder.size());
  CHECK(std::vector(never.begin(), never.begin() + std::ptrdiff_t(ladder.size())) == ladder);
  // A slope that is not the objective's own cannot become zero where the objective is least.
  Problem p = bowl(2, {1.0, -1.0}, 0.5);
  p.evaluate = [right = p.evaluate](std::span<const double> x, bool gradient) {
    Evaluation e = right(x, gradient);
    for (double& d : e.jacobian) d = std::abs(d) + 1.0;
    return e;
  };
  p.variables[0].lower = p.variables[1].lower = -1e3;
  const Result wrong = solve(p, options);
  if (wrong.outcome == Outcome::feasible) {
    ladder.insert(ladder.end(), {"nlopt:ccsaq", "nlopt:auglag", "nlopt:sbplx"});
    CHECK(solvers_of(wrong) == ladder);
  }
  CHECK(wrong.outcome == Outcome::feasible);
}

TEST_CASE("a certified optimum does not replace a design that is clearly better", "[optim]") {
  // Beside its bound the objective is a narrow shelf that ends in a jump, where nothing can be
  // certified; further on a parabola, which is never as low.
  Problem p;
  p.variables = test::box(1, 0.0, 1.0, {0.001});
  p.objectives = {{"f"}};
  p.evaluate = [](std::span<const double> x, bool) {
    Evaluation e;
    const bool shelf = x[0] < 0.005;
    e.values = {shelf ? -1.0 - x[0] : (x[0] - 0.8) * (x[0] - 0.8)};
    e.jacobian = {shelf ? -1.0 : 2.0 * (x[0] - 0.8)};
    return e;
  };
  const Result r = solve(p);
  CHECK(r.evaluation.values[0] < -1.0);
  CHECK(r.outcome == Outcome::feasible);
}

TEST_CASE("whole numbers are tried within their bounds, all of them or from neighbour to neighbour",
          "[optim][integer]") {
  for (const std::size_t n : {1U, 2U, 3U}) {
    for (const double most : {3.0, 9.0}) {
      for (const bool up : {true, false}) {
        const Problem p = wholes(std::vector<double>(n, up ? most + 5.0 : -5.0), most,
                                 std::vector<double>(n, 2.0));
        SolveOptions options;
        std::set<std::vector<double>> seen;
        options.observer = [&](const Observation& o) {
          seen.emplace(o.design.begin(), o.design.end());
        };
        const Result r = solve(p, options);
        CAPTURE(n, most, up);
        CHECK(r.outcome == Outcome::optimal);
        CHECK(r.design == std::vector<double>(n, up ? most : 0.0));
        for (const auto& x : seen)
          for (const double v : x) CHECK((v >= 0.0 && v <= most && v == std::floor(v)));
        const double all = std::pow(most + 1.0, double(n));
        if (all <= 64.0) CHECK(double(seen.size()) == all);
      }
    }
  }
}

TEST_CASE("whole numbers that cannot be evaluated are not walked through", "[optim][integer]") {
  Problem p = wholes({8.0, 8.0}, 9.0, {3.0, 3.0});
  p.evaluate = [](std::span<const double>, bool) { return Evaluation{{}, {}, {}, "torn"}; };
  SolveOptions options;
  double furthest = 0.0;
  options.observer = [&](const Observation& o) {
    furthest = std::max(furthest, std::abs(o.design[0] - 3.0) + std::abs(o.design[1] - 3.0));
  };
  CHECK(solve(p, options).outcome == Outcome::failed);
  CHECK(furthest == 1.0);  // only better neighbours lead on
}

TEST_CASE("a contradiction is explained only to those who ask", "[optim][integer]") {
  Problem p = contradiction();
  p.variables[0].integer = true;
  p.variables[0].lower = 1.0;
  SolveOptions options;
  options.starts = 1;
  options.analyse_infeasible = false;
  const Result silent = solve(p, options);
  CHECK(silent.outcome == Outcome::infeasible);
  CHECK(silent.infeasibility.relaxations.empty());
  CHECK(silent.infeasibility.conflict.empty());
  options.analyse_infeasible = true;
  CHECK_FALSE(solve(p, options).infeasibility.conflict.empty());
}
