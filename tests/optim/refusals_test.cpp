// SPDX-License-Identifier: Apache-2.0
// What a certificate says where there is no plain optimum, what a search says when it is cut short at
// any moment, and what is refused before it begins.
#include "optim/bank/dual_problem.hpp"

#include <twum/base/error.hpp>
#include <twum/optim/least_squares.hpp>
#include <twum/optim/pareto.hpp>
#include <twum/optim/solve.hpp>
#include <twum/optim/solvers.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>

using namespace twum;
using namespace twum::optim;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

using D = Dual<double, 2>;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Problem plane(std::size_t objectives, std::vector<Constraint> constraints,
              std::function<void(const D*, D*)> f) {
  Problem p;
  p.variables = test::box(2, -2.0, 2.0, {1.0, 1.0});
  for (std::size_t k = 0; k < objectives; ++k) p.objectives.push_back({test::numbered('f', k)});
  p.constraints = std::move(constraints);
  p.evaluate = test::dual_evaluator<2>(p.responses(), f);
  return p;
}

// x^2 + y^2 with x + y >= least: the optimum is x = y = least / 2.
Problem bowl(double least) {
  return plane(1, {{"sum", least}}, [](const D* x, D* r) {
    r[0] = x[0] * x[0] + x[1] * x[1];
    r[1] = x[0] + x[1];
  });
}

// x + y >= 3 and x^2 + y^2 <= 1 cannot both hold.
Problem contradiction(std::size_t objectives) {
  return plane(objectives, {{"sum", 3.0}, {"circle", -kInfinity, 1.0}},
               [objectives](const D* x, D* r) {
                 for (std::size_t k = 0; k < objectives; ++k) r[k] = x[k] * x[k];
                 r[objectives] = x[0] + x[1];
                 r[objectives + 1] = x[0] * x[0] + x[1] * x[1];
               });
}

// Squared distances from (0, 0) and (1, 0), above y = 0.5 - x: the front lies on y = 0 where that is
// allowed, and on the line where it is not.
Problem two_distances() {
  return plane(2, {{"line", 0.5}}, [](const D* x, D* r) {
    const D far = x[0] - 1.0;
    r[0] = x[0] * x[0] + x[1] * x[1];
    r[1] = far * far + x[1] * x[1];
    r[2] = x[0] + x[1];
  });
}

// The same, but a derivative of one response does not exist.
Problem without_slope(Problem p, std::size_t response, bool says_so) {
  p.evaluate = [right = p.evaluate, response, says_so](std::span<const double> x, bool gradient) {
    Evaluation e = right(x, gradient);
    if (!gradient) return e;
    if (says_so)
      e.kinks.push_back({response, 0, Slope::undefined, 0.0, 0.0});
    else
      e.jacobian[2 * response] = kNaN;
    return e;
  };
  return p;
}

bool has(const Certificate& c, Degeneracy kind) {
  return std::any_of(c.findings.begin(), c.findings.end(),
                     [&](const Finding& f) { return f.kind == kind; });
}

bool holds(const Problem& p, const Evaluation& e) {
  for (std::size_t i = 0; i < p.constraints.size(); ++i) {
    const double value = e.values[p.objectives.size() + i];
    // 1e-8 of the scaled constraint, whose slope at (1, 1) is at most 8 over the box.
    if (value < p.constraints[i].lower - 1e-7 || value > p.constraints[i].upper + 1e-7)
      return false;
  }
  return true;
}

}  // namespace

TEST_CASE("a derivative that does not exist matters where it holds the design",
          "[optim][certificate]") {
  const Problem held = bowl(1.0), loose = bowl(-1.0);
  const std::vector<double> corner{0.5, 0.5}, bottom{0.0, 0.0};
  REQUIRE(certify(held, corner).passed);
  REQUIRE(certify(loose, bottom).passed);
  for (const bool says_so : {true, false}) {
    CAPTURE(says_so);
    for (const auto& c : {certify(without_slope(held, 0, says_so), corner),
                          certify(without_slope(held, 1, says_so), corner),
                          certify(without_slope(loose, 0, says_so), bottom)}) {
      CHECK_FALSE(c.passed);
      CHECK(c.reason == "a derivative does not exist");
      CHECK(has(c, Degeneracy::undefined_gradient));
      CHECK(std::isinf(c.stationarity));
    }
    CHECK(certify(without_slope(loose, 1, says_so), bottom).passed);
  }
}

TEST_CASE("a maximum may have a kink too", "[optim][certificate][kink]") {
  // -|x| - y^2, whose one-sided derivatives in x are +1 on the left and -1 on the right of 0.
  Problem p =
      plane(1, {}, [](const D* x, D* r) { r[0] = (x[0].v < 0 ? x[0] : -x[0]) - x[1] * x[1]; });
  p.objectives[0].sense = Sense::maximize;
  const std::vector<double> top{0.0, 0.0}, beside{0.5, 0.0};
  CHECK(certify(p, top).passed);  // found by gradients on both sides
  CHECK(has(certify(p, top), Degeneracy::kink));
  CHECK_FALSE(certify(p, beside).passed);
  p.evaluate = [right = p.evaluate](std::span<const double> x, bool gradient) {
    Evaluation e = right(x, gradient);
    if (x[0] == 0.0) e.kinks.push_back({0, 0, Slope::one_sided, 1.0, -1.0});
    return e;
  };
  CHECK(certify(p, top).passed);  // told
  CHECK(has(certify(p, top), Degeneracy::kink));
}

TEST_CASE("a certificate says what it lacks", "[optim][certificate]") {
  const std::vector<double> origin{0.0, 0.0};
  CHECK(certify(bowl(1.0), origin).reason == "a constraint is violated");
  CHECK_THAT(certify(bowl(-1.0), std::vector{0.1, 0.0}).reason, Contains("not stationary"));
  const Problem saddle = plane(1, {}, [](const D* x, D* r) { r[0] = x[0] * x[0] - x[1] * x[1]; });
  CHECK(certify(saddle, origin).reason == "stationary, but not a minimum");
  CHECK(has(certify(saddle, origin), Degeneracy::negative_curvature));
  const Problem flat = plane(1, {}, [](const D*, D* r) { r[0] = D(7.0); });
  CHECK(has(certify(flat, origin), Degeneracy::flat_objective));
  CHECK_THROWS_WITH(certify(saddle, std::vector{0.0}),
                    Contains("the design has 1 values for 2 variables"));

  Problem broken = saddle;
  broken.evaluate = [](std::span<const double>, bool) { return Evaluation{{}, {}, {}, "torn"}; };
  CHECK(certify(broken, origin).reason == "the design cannot be evaluated");
  std::stop_source stop;
  stop.request_stop();
  SolveOptions options;
  options.stop = stop.get_token();
  CHECK_FALSE(certify(saddle, origin, options).passed);
  CHECK(certify(saddle, origin, options).reason == "stopped before the test was done");
  for (const std::size_t few : {1U, 2U, 3U, 4U, 5U, 6U}) {
    options = {};
    options.budget.evaluations = few;  // less than the curvature takes
    const Certificate c = certify(saddle, origin, options);
    CAPTURE(few, c.reason);
    CHECK((!c.passed || std::isnan(c.curvature)));
  }
}

TEST_CASE("words of outcomes and findings are different ones", "[optim]") {
  std::set<std::string> words;
  for (const Degeneracy d :
       {Degeneracy::flat_direction, Degeneracy::flat_objective, Degeneracy::dependent_constraints,
        Degeneracy::kink, Degeneracy::negative_curvature, Degeneracy::undefined_gradient})
    words.insert(to_string(d));
  for (const Outcome o :
       {Outcome::optimal, Outcome::feasible, Outcome::infeasible, Outcome::budget, Outcome::failed})
    words.insert(to_string(o));
  CHECK(words.size() == 11);
  CHECK_FALSE(words.contains("unknown"));
}

TEST_CASE("wherever a budget ends, what is said of the design is true", "[optim][budget]") {
  const std::vector<Problem> problems{bowl(1.0), contradiction(1), bowl(-1.0)};
  std::vector<std::string> solvers{"auto", "nlopt:slsqp", "nlopt:mma", "nlopt:cobyla",
                                   "nlopt:isres"};
  if (find_solver("ipopt").available) solvers.push_back("ipopt");
  for (std::size_t which = 0; which < problems.size(); ++which) {
    const Problem& p = problems[which];
    for (const std::string& solver : solvers) {
      for (std::size_t calls = 1; calls < 400; calls += 1 + calls / 6) {
        SolveOptions options;
        options.solver = solver;
        options.starts = 3;
        options.budget.evaluations = calls;
        const Result r = solve(p, options);
        INFO(which << ' ' << solver << ' ' << calls << ' ' << to_string(r.outcome));
        CHECK(r.counters.evaluations <= calls);
        CHECK((r.outcome == Outcome::optimal) ==
              (r.certificate.passed && r.certificate.reason.empty()));
        if (r.outcome == Outcome::optimal || r.outcome == Outcome::feasible)
          CHECK(holds(p, p.evaluate(r.design, false)));
        if (r.outcome == Outcome::infeasible) CHECK(which == 1);
        if (r.outcome == Outcome::budget) CHECK(r.stop == StopReason::evaluations);
      }
    }
  }
}

TEST_CASE("wherever a budget ends, a front is one", "[optim][pareto][budget]") {
  const Problem p = two_distances();
  for (std::size_t calls = 1; calls < 1500; calls += 1 + calls / 5) {
    ParetoOptions options;
    options.points = 9;
    options.coarse = 4;
    options.solve.starts = 3;
    options.solve.budget.evaluations = calls;
    const Front front = pareto_front(p, options);
    CAPTURE(calls);
    CHECK(front.counters.evaluations <= calls);
    bool certified = true;
    for (const FrontPoint& point : front.points) {
      CHECK(holds(p, point.evaluation));
      certified = certified && point.certificate.passed;
    }
    for (std::size_t i = 1; i < front.points.size(); ++i) {  // none dominates another
      CHECK(front.points[i - 1].evaluation.values[0] < front.points[i].evaluation.values[0]);
      CHECK(front.points[i - 1].evaluation.values[1] > front.points[i].evaluation.values[1]);
    }
    if (front.outcome == Outcome::optimal) CHECK((certified && front.points.size() >= 2));
    const Front none = pareto_front(contradiction(2), options);
    CHECK(none.points.empty());
    CHECK(none.counters.evaluations <= calls);
    CHECK((none.outcome == Outcome::budget || none.outcome == Outcome::infeasible));
  }
}

TEST_CASE("a front of two objectives that agree is their common optimum", "[optim][pareto]") {
  const Problem p = plane(2, {}, [](const D* x, D* r) {
    r[0] = x[0] * x[0] + x[1] * x[1];
    r[1] = 3.0 * r[0] + 1.0;
  });
  ParetoOptions options;
  options.points = 5;
  const Front front = pareto_front(p, options);
  REQUIRE(front.points.size() == 1);
  CHECK(std::abs(front.points[0].design[0]) < 1e-6);  // of a parabola, to the square root of 1e-12
  CHECK(std::abs(front.points[0].design[1]) < 1e-6);
}

TEST_CASE("problems that cannot be posed are refused by the entry that is wrong",
          "[optim][error]") {
  const auto refusal = [](const std::function<void(Problem&)>& spoil) -> std::string {
    Problem p = bowl(1.0);
    spoil(p);
    try {
      solve(p);
    } catch (const InputError& e) {
      return e.what();
    }
    return "accepted";
  };
  CHECK_THAT(refusal([](Problem& p) { p.variables[1].upper = kInfinity; }),
             Contains("'x2': the bounds must be finite"));
  CHECK_THAT(refusal([](Problem& p) { p.variables[0].lower = kNaN; }),
             Contains("'x1': the bounds must be finite"));
  CHECK_THAT(refusal([](Problem& p) { p.variables[0].lower = 3.0; }),
             Contains("lies above the upper"));
  CHECK_THAT(refusal([](Problem& p) { p.variables[0].scale = Scale::log; }),
             Contains("a log scale needs a lower bound > 0"));
  CHECK_THAT(refusal([](Problem& p) { p.variables[0].start = kInfinity; }),
             Contains("the start must be finite"));
  CHECK_THAT(refusal([](Problem& p) {
               p.variables[0] = {"x1", 0.2, 0.8};
               p.variables[0].integer = true;
             }),
             Contains("no whole number between the bounds"));
  CHECK_THAT(refusal([](Problem& p) { p.constraints[0].upper = kNaN; }),
             Contains("'sum': a limit is not a number"));
  CHECK_THAT(refusal([](Problem& p) { p.constraints[0].lower = kNaN; }),
             Contains("'sum': a limit is not a number"));
  CHECK_THAT(refusal([](Problem& p) { p.constraints[0].lower = -kInfinity; }),
             Contains("'sum': it has no limit"));
  CHECK_THAT(refusal([](Problem& p) { p.constraints[0].lower = kInfinity; }), Contains("'sum': "));
  CHECK_THAT(refusal([](Problem& p) { p.constraints[0].upper = 0.5; }),
             Contains("'sum': the limits cross"));
  CHECK_THAT(refusal([](Problem& p) { p.constraints[0].name.clear(); }),
             Contains("a constraint has no name"));
  CHECK_THAT(refusal([](Problem& p) { p.variables[1].name = "x1"; }),
             Contains("variable 'x1' is given twice"));
  CHECK_THAT(refusal([](Problem& p) { p.objectives.clear(); }), Contains("no objective"));
  CHECK_THAT(refusal([](Problem& p) { p.variables.clear(); }), Contains("no variable"));
  CHECK_THAT(refusal([](Problem& p) { p.evaluate = nullptr; }), Contains("no evaluator"));
}

TEST_CASE("fits that cannot be posed are refused by the parameter that is wrong",
          "[optim][least_squares][error]") {
  // y = a + b t at t = 0, 1, 2 with y = 1, 3, 5: a = 1, b = 2.
  const auto line = [](std::span<const double> b) {
    return Residuals{{b[0] - 1, b[0] + b[1] - 3, b[0] + 2 * b[1] - 5}, {1, 0, 1, 1, 1, 2}, {}};
  };
  std::vector<Variable> good(2);
  good[0] = {"a", -10.0, 10.0, 0.0};
  good[1] = {"b", 0.1, 10.0};
  const LeastSquaresResult fit = least_squares(good, line);
  REQUIRE(fit.outcome == Outcome::optimal);
  CHECK(fit.estimates[0].value == Approx(1.0).epsilon(1e-12));
  CHECK(fit.estimates[1].value == Approx(2.0).epsilon(1e-12));

  const auto refused = [&](std::size_t j, const Variable& v, const std::string& words) {
    auto bad = good;
    bad[j] = v;
    CHECK_THROWS_WITH(least_squares(bad, line), Contains(words));
  };
  refused(0, {"a", 1.0, -1.0}, "parameter 'a': the bounds do not fit");
  refused(0, {"a", 0.0, 1.0, kNaN, Scale::log}, "parameter 'a': the bounds do not fit");
  refused(0, {"a", -kInfinity, kInfinity}, "parameter 'a': it needs a start");
  refused(0, {"", 0.0, 1.0}, "the name is empty or given twice");
  refused(0, {"b", 0.0, 1.0}, "the name is empty or given twice");
  CHECK_THROWS_WITH(least_squares({}, line), Contains("there is no parameter"));
  CHECK_THROWS_WITH(least_squares(good,
                                  [](std::span<const double>) {
                                    return Residuals{{1}, {1, 0}, {}};
                                  }),
                    Contains("fewer residuals than free parameters"));
  CHECK_THROWS_WITH(least_squares(good,
                                  [](std::span<const double>) {
                                    return Residuals{{1, 2}, {1}, {}};
                                  }),
                    Contains("the Jacobian has the wrong size"));

  const auto torn = least_squares(good, [](std::span<const double>) {
    return Residuals{{}, {}, "torn"};
  });
  CHECK(torn.outcome == Outcome::failed);
  CHECK(torn.counters.failures.at("torn") == 1);
  const auto nowhere = least_squares(good, [](std::span<const double>) -> Residuals {
    return {{kNaN, 0, 0}, {1, 0, 1, 1, 1, 2}, {}};
  });
  CHECK(nowhere.outcome == Outcome::failed);
  CHECK(nowhere.counters.failures.at("not-finite") == 1);

  LeastSquaresOptions options;
  std::stop_source stop;
  stop.request_stop();
  options.stop = stop.get_token();
  CHECK(least_squares(good, line, options).outcome != Outcome::optimal);
  options = {};
  options.max_evaluations = 1;
  CHECK(least_squares(good, line, options).outcome == Outcome::budget);
}

TEST_CASE("Ipopt's own words reach the report of its stage", "[optim][ipopt]") {
  if (!find_solver("ipopt").available) return;
  SolveOptions options;
  options.solver = "ipopt";
  options.polish = false;
  options.solver_options = {{"max_iter", "1"}};
  const Result few = solve(bowl(1.0), options);
  REQUIRE_FALSE(few.stages.empty());
  CHECK_THAT(few.stages.front().word, StartsWith("Maximum_Iterations_Exceeded"));
  options.solver_options.clear();
  const Result done = solve(bowl(1.0), options);
  CHECK_THAT(done.stages.front().word, StartsWith("Solve_Succeeded"));
  const Result never = solve(contradiction(1), options);
  CHECK(never.outcome == Outcome::infeasible);
  CHECK_THAT(never.stages.front().word, StartsWith("Infeasible_Problem_Detected"));
}
