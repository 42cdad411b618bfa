// SPDX-License-Identifier: Apache-2.0
// What could keep a search going without end: limits that cannot be met, points that are remembered, numbers
// that overflow, and a request to stop that nobody looks at.
#include "optim/inside/scaled_search.hpp"

#include <twum/optim/solve.hpp>
#include <twum/optim/solvers.hpp>

#include "search/solve_continuous.hpp"
#include "solvers/allowance.hpp"
#include "solvers/augmented_lagrangian.hpp"
#include "solvers/restarts.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace twum;
using namespace twum::optim;
using test::D3;

namespace {

// Over [0, 1] the objective rises, and both limits hold it where x cannot go.
Problem torn() {
  return test::posed<3>(test::box(1, 0.0, 1.0, {0.2}),
                        {{"far", 2.0, kInfinity}, {"low", -kInfinity, 0.5}},
                        [](const D3* x, D3* r) {
                          r[0] = x[0];
                          r[1] = x[0] + 0.25 * x[0] * x[0];
                          r[2] = x[0] * x[0];
                        });
}

// A problem at its start, with the memory and the counts of one stage.
struct Stage {
  explicit Stage(Problem p, std::stop_token stop = {}) : problem(std::move(p)), scaling(problem) {
    options.stop = std::move(stop);
  }
  Nlp nlp() { return Nlp(session, scaling, plain_formulation(problem, scaling)); }

  Problem problem;
  SolveOptions options;
  Deadline deadline{kInfinity};
  Session session{problem, options, deadline, 0, 100000};
  Scaling scaling;
};

}  // namespace

TEST_CASE("limits that cannot be met end every solver, well within its calls",
          "[optim][budget][solvers]") {
  for (const SolverInfo& solver : solvers()) {
    if (!solver.available) continue;
    SolveOptions options;
    options.solver = solver.name;
    options.budget.evaluations = 20000;
    options.analyse_infeasible = false;
    const Result r = solve(torn(), options);
    CAPTURE(solver.name, r.stages.front().word);
    CHECK((r.outcome == Outcome::infeasible || r.outcome == Outcome::budget));
    // A local solver has 3000 + 300 n calls a run and six runs at most; 20000 rule the others.
    CHECK(r.counters.evaluations <= 20000);
    // Each point is asked for by the objective and by two lists of limits, and 1000 requests in a row
    // without an evaluation end a run, of which there are at most 60 a stage.
    CHECK(r.counters.reused <= 3 * 20000 + 6 * 60 * 1000);
  }
}

TEST_CASE("violation and penalty follow the linear rate of the method of multipliers",
          "[optim][lagrangian][convergence]") {
  // f = k x^2 / 2 with x = 1. The minimum of the Lagrangian at multiplier l and penalty p is
  // (p - l) / (k + p), and the next multiplier l + p (x - 1): the violation shrinks by k / (k + p).
  const double k = 3.0;
  AugmentedLagrangian lagrangian({{0, 1.0, 1.0, true}}, 1e-12);
  const auto at = [&](double x) { return NlpValue{0.5 * k * x * x, {x}, {k * x}, {1.0}}; };
  const auto argmin = [&] {  // the Lagrangian is a parabola: its slope is a line
    const double s0 = lagrangian.gradient(at(0.0))[0], s1 = lagrangian.gradient(at(1.0))[0];
    return -s0 / (s1 - s0);
  };
  double before = std::abs(argmin() - 1.0);
  int steps = 1;
  while (lagrangian.advance(at(argmin()))) {
    const double violation = std::abs(argmin() - 1.0);
    // The penalty stays 10 as 3 / 13 is below a half. Rounding of x near 1 is 1e-16, of 1e-12 at least.
    CHECK(violation == Approx(before * k / (k + 10.0)).epsilon(1e-3).margin(1e-15));
    before = violation;
    ++steps;
  }
  // 3/13 in the first step, and so on until 1e-12: log(1e-12) / log(3/13) = 18.8
  CHECK(steps == 19);
}

TEST_CASE("slopes of a Lagrangian are those of its values", "[optim][lagrangian][derivative]") {
  AugmentedLagrangian lagrangian({{0, 1.0, 1.0, true}, {1, -1.0, 0.2, false}, {2, 1.0, 5.0, false}},
                                 1e-9);
  const auto at = [](double x) {
    return NlpValue{std::exp(x), {x * x, std::sin(x), x}, {std::exp(x)}, {2 * x, std::cos(x), 1.0}};
  };
  lagrangian.advance(at(-0.3));  // multipliers that are not zero
  for (const double x : {-0.9, -0.1, 0.6}) {
    const double h = 1e-5;
    const double slope = (lagrangian.value(at(x + h)) - lagrangian.value(at(x - h))) / (2 * h);
    // Central differences err by h^2 / 6 times the third derivative, some hundred with a penalty of
    // 10 to 100, and by 1e-16 / h times a value of some hundred.
    CHECK(lagrangian.gradient(at(x))[0] == Approx(slope).epsilon(1e-7).margin(1e-7));
  }
}

TEST_CASE("a Lagrangian gives up on limits that cannot be met", "[optim][lagrangian]") {
  AugmentedLagrangian lagrangian({{0, 1.0, -1.0, false}}, 1e-9);
  const NlpValue stuck{0.0, {0.5}, {0.0}, {0.0}};  // g = 1.5 whatever is done
  lagrangian.begin(stuck);
  int steps = 0;
  while (steps < 1000 && lagrangian.advance(stuck)) ++steps;
  CHECK(steps <= 10);
  CHECK(std::isfinite(lagrangian.value(stuck)));
  CHECK(std::isfinite(lagrangian.gradient(stuck)[0]));
}

TEST_CASE("a start that meets its limits with an objective of zero gives a finite penalty",
          "[optim][lagrangian][edge]") {
  AugmentedLagrangian lagrangian({{0, 1.0, 0.0, false}}, 1e-9);
  lagrangian.begin({0.0, {0.0}, {1.0}, {1.0}});
  // On the limit L = f + p/2 g^2 with p in [1e-6, 10]: at g = 1 and f = 0 it is p / 2.
  const double half = lagrangian.value({0.0, {1.0}, {1.0}, {1.0}});
  CHECK(half >= 0.5e-6);
  CHECK(half <= 5.0);
}

TEST_CASE("asking for nothing but what is known ends a run", "[optim][nlp][budget]") {
  const double nan = std::nan("");
  const std::vector<std::vector<std::vector<double>>> circles{
      {{0.2}}, {{0.2}, {0.3}}, {{nan}}, {{nan}, {0.2}}};
  for (const auto& circle : circles) {
    Stage stage(torn());
    Nlp nlp = stage.nlp();
    Allowance allowance(nlp, static_cast<std::size_t>(-1), Allowance::Search::local);
    std::size_t asked = 0;
    while (asked < 100000 && allowance.take(circle[asked % circle.size()]))
      nlp.at(circle[asked++ % circle.size()], true);
    CAPTURE(circle.size());
    CHECK(asked < 2000);
    CHECK(std::string(allowance.word()) == "STALLED");
    CHECK_FALSE(allowance.take(std::vector{0.7}));
    CHECK(stage.session.counters().evaluations <= circle.size());
  }
}

TEST_CASE("a local search ends if its best design no longer gets better", "[optim][nlp][budget]") {
  // Points at which f = x grows from the first one on; each tenth is a new best one if `gains`.
  const auto asked = [](Allowance::Search search, bool gains) {
    Problem problem;
    problem.variables = {{"x", 0.0, 1.0, 0.5}};
    problem.objectives = {{"f"}};
    problem.evaluate = [](std::span<const double> x, bool) {
      return Evaluation{{x[0]}, {1.0}, {}, {}};
    };
    Stage stage(problem);
    Nlp nlp = stage.nlp();
    Allowance allowance(nlp, 2000, search);
    int points = 0;
    for (; points < 2000; ++points) {
      const double worse = 0.9 + 1e-5 * points, best = 0.8 - 1e-3 * points / 10;
      const std::vector<double> z{points == 0 || (gains && points % 10 == 0) ? best : worse};
      if (!allowance.take(z)) break;
      nlp.at(z, true);
    }
    return points;
  };
  // 60 + 20 n points, after the first one.
  CHECK(asked(Allowance::Search::local, false) == 82);
  CHECK(asked(Allowance::Search::local, true) == 2000);
  CHECK(asked(Allowance::Search::global, false) == 2000);
}

TEST_CASE("a request to stop reaches a solver that asks for nothing new", "[optim][nlp][budget]") {
  std::stop_source source;
  Stage stage(torn(), source.get_token());
  Nlp nlp = stage.nlp();
  const std::vector<double> here{0.2};
  REQUIRE(nlp.at(here, true) != nullptr);
  REQUIRE(nlp.at(here, true) != nullptr);
  source.request_stop();
  CHECK_THROWS_AS(nlp.at(here, true), Stop);
}

TEST_CASE("numbers whose squares overflow reach no solver", "[optim][nlp][edge]") {
  for (const double size : {1e20, 1e40, 1e160, 1e300}) {
    for (const std::size_t large : {0U, 1U}) {  // the objective, or a limit
      Problem p = torn();
      p.evaluate = [=, plain = p.evaluate](std::span<const double> x, bool gradient) {
        Evaluation e = plain(x, gradient);
        e.values[large] *= size;
        for (double& d : e.jacobian) d *= d == e.jacobian[large] ? size : 1.0;
        return e;
      };
      Stage stage(p);
      Nlp nlp = stage.nlp();  // its factors are 1: nothing was scaled
      CAPTURE(size, large);
      CHECK((nlp.at(std::vector{0.9}, true) != nullptr) == (size < 1e30));
      CHECK((nlp.at(std::vector{0.8}, false) != nullptr) == (size < 1e30));
    }
  }
}

TEST_CASE("numbers whose squares vanish reach a solver as zeros", "[optim][nlp][edge]") {
  for (const double size : {1e-50, 1e-90, 1e-150, 1e-300}) {
    Problem p = torn();
    p.constraints[0] = {"far", size * 0.5, kInfinity};
    p.evaluate = [=, plain = p.evaluate](std::span<const double> x, bool gradient) {
      Evaluation e = plain(x, gradient);
      e.values[1] *= size;
      if (gradient) e.jacobian[1] *= size;
      return e;
    };
    Stage stage(p);
    Nlp nlp = stage.nlp();  // its factors are 1: nothing was scaled
    const NlpValue* v = nlp.at(std::vector{0.9}, true);
    REQUIRE(v != nullptr);
    CAPTURE(size);
    const bool small = size < 1e-100;
    CHECK((v->c[0] == 0.0) == small);
    CHECK((v->dc[0] == 0.0) == small);
    CHECK((OneSide{0, -1.0, size * 0.5}.of(*v) == 0.0) == small);
  }
}

TEST_CASE(
    "a run that lost its way begins again at the best design, not beside a point that is none",
    "[optim][nlp][edge]") {
  Stage stage(torn());
  Nlp nlp = stage.nlp();
  Restarts restarts(nlp, std::vector{0.2});
  const std::vector<double> nowhere{std::nan("")};
  CHECK_FALSE(restarts.next(nowhere, nowhere));  // nothing is known yet
  REQUIRE(nlp.at(std::vector{0.4}, true) != nullptr);
  for (int i = 0; i < 5; ++i) {
    REQUIRE(restarts.next(nowhere, nowhere));
    CHECK(restarts.from() == std::vector{0.4});
    CHECK(nlp.lower()[0] < nlp.upper()[0]);
  }
}

TEST_CASE("a ladder to its top tries every rung, whatever has been found", "[optim][solve]") {
  Problem bowl = test::posed<3>(test::box(2, -1.0, 2.0, {1.5, -0.5}), {},
                                [](const D3* x, D3* r) { r[0] = x[0] * x[0] + x[1] * x[1]; });
  for (const Problem& p : {bowl, torn()}) {
    SolveOptions options;
    options.starts = 1;
    options.analyse_infeasible = false;
    Ladder ladder;
    ladder.to_the_top = true;
    const Result r = solve_continuous(p, options, Deadline(kInfinity), ladder);
    std::vector<std::string> tried;
    for (const StageReport& stage : r.stages) tried.push_back(stage.solver);
    std::erase_if(ladder.rungs,
                  [](const std::string& rung) { return !find_solver(rung).available; });
    ladder.rungs.insert(ladder.rungs.begin(), "nlopt:slsqp");  // the start itself
    REQUIRE(tried.size() >= ladder.rungs.size());
    tried.resize(ladder.rungs.size());
    CHECK(tried == ladder.rungs);
  }
}

TEST_CASE("a Lagrangian that overflows is a failed point, and the search ends",
          "[optim][lagrangian][edge]") {
  // f and c can be reckoned with, but the penalty times c^2 cannot.
  Problem p = torn();
  p.evaluate = [plain = p.evaluate](std::span<const double> x, bool gradient) {
    Evaluation e = plain(x, gradient);
    if (x[0] > 0.5) e.values[1] = -1e29;
    return e;
  };
  for (const std::string solver : {"nlopt:bobyqa", "nlopt:lbfgs", "nlopt:sbplx"}) {
    SolveOptions options;
    options.solver = solver;
    options.analyse_infeasible = false;
    const Result r = solve(p, options);
    CAPTURE(solver);
    CHECK(r.outcome == Outcome::infeasible);
    CHECK(r.counters.evaluations < 20000);
  }
}
