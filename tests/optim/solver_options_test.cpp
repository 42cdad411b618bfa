// SPDX-License-Identifier: Apache-2.0
// The list of solvers and the list of their options keep what they promise.
#include "optim/bank/posed.hpp"

#include <twum/base/error.hpp>
#include <twum/optim/solve.hpp>
#include <twum/optim/solvers.hpp>

#include <catch2/catch.hpp>

#include <charconv>
#include <cmath>
#include <map>
#include <string>
#include <vector>

using namespace twum;
using namespace twum::optim;

namespace {

using D = Dual<double, 2>;

struct Range {
  double least, most;
};

// The ranges as documentation and users' files have them.
const std::map<std::string, Range> kRanges{{"xtol_rel", {0, 1}},
                                           {"ftol_rel", {0, 1}},
                                           {"constraint_tolerance", {0, 1}},
                                           {"population", {0, 1e6}},
                                           {"vector_storage", {0, 1e4}},
                                           {"initial_step", {0, 1}},
                                           {"inner_evaluations", {1, 1e9}},
                                           {"tol", {1e-14, 0.1}},
                                           {"acceptable_tol", {1e-14, 1}},
                                           {"constr_viol_tol", {1e-14, 1}},
                                           {"max_iter", {0, 1e6}},
                                           {"mu_init", {1e-12, 1e6}},
                                           {"bound_relax_factor", {0, 0.01}},
                                           {"limited_memory_max_history", {1, 1000}},
                                           {"print_level", {0, 12}}};

// A bowl above a line: with a limit, so that every option has something to act on.
Problem bowl() {
  return test::posed<2>(test::box(2, -2.0, 2.0, {1.0, -1.0}), {{"line", 0.0}},
                        [](const D* x, D* r) {
                          r[0] = (x[0] - 0.3) * (x[0] - 0.3) + x[1] * x[1];
                          r[1] = x[0] + x[1];
                        });
}

std::string shortest(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

// Whether a solver takes the value of an option, by a search of a few calls.
bool takes(const SolverOption& option, double value) {
  SolveOptions options;
  options.solver = option.solver == "ipopt" ? "ipopt" : "nlopt:slsqp";
  options.solver_options = {{option.name, shortest(value)}};
  options.budget.evaluations = 8;
  try {
    solve(bowl(), options);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace

TEST_CASE("every option of a solver takes its range, the ends included, and nothing beyond",
          "[optim][definition]") {
  std::size_t ranges = 0;
  for (const SolverOption& option : solver_options()) {
    CAPTURE(option.solver, option.name);
    if (option.type == "text") continue;
    REQUIRE(kRanges.contains(option.name));
    const auto [least, most] = kRanges.at(option.name);
    ++ranges;
    const bool whole = option.type == "integer";
    CHECK(takes(option, least));
    CHECK_FALSE(takes(option, whole ? least - 1 : std::nextafter(least, -1.0)));
    CHECK_FALSE(takes(option, whole ? most + 1 : std::nextafter(most, 2 * most)));
    if (option.name != "print_level") CHECK(takes(option, most));  // that would print a lot
    if (whole) CHECK_FALSE(takes(option, least + 0.5));
    if (!whole) CHECK(takes(option, 0.5 * (least + most)));
  }
  CHECK(ranges == (find_solver("ipopt").available ? 15 : 7));
}

TEST_CASE("Ipopt is told to need slopes, to take constraints, and not to search the whole box",
          "[optim][definition]") {
  const SolverInfo& ipopt = find_solver("ipopt");
  if (!ipopt.available) return;
  CHECK(ipopt.gradient);
  CHECK(ipopt.inequality);
  CHECK(ipopt.equality);
  CHECK_FALSE(ipopt.augmented);
  CHECK_FALSE(ipopt.global);
  CHECK_FALSE(ipopt.stochastic);
}

TEST_CASE("every solver takes equalities, its own or by an augmented Lagrangian",
          "[optim][definition]") {
  for (const SolverInfo& solver : solvers()) {
    CAPTURE(solver.name);
    CHECK(solver.equality);
    CHECK(solver.inequality);
    CHECK_FALSE(solver.description.empty());
  }
}

TEST_CASE("a first step is as long as it is told to be, in parts of the box",
          "[optim][definition]") {
  Problem p = bowl();
  p.constraints.clear();
  p.evaluate = test::dual_evaluator<2>(1, [](const D* x, D* r) { r[0] = x[0] + 2.0 * x[1]; });
  for (const double step : {0.01, 0.03, 0.1}) {
    std::vector<std::vector<double>> moved;
    SolveOptions options;
    options.solver = "nlopt:neldermead";
    options.solver_options = {{"initial_step", shortest(step)}};
    options.observer = [&](const Observation& o) {
      if (o.design[0] != 1.0 || o.design[1] != -1.0)
        moved.emplace_back(o.design.begin(), o.design.end());
    };
    solve(p, options);
    // The simplex begins with the start and, for each variable, the start with that variable moved.
    REQUIRE(moved.size() > 2);
    for (const std::size_t k : {0U, 1U})
      CHECK(
          std::abs(moved[k][0] - 1.0) + std::abs(moved[k][1] + 1.0) ==
          Approx(4.0 * step).epsilon(1e-13));  // of a box 4 wide, by differences of numbers near 1
  }
}

TEST_CASE("a solver that ends by itself gives its own word for it", "[optim][definition]") {
  SolveOptions options;
  options.solver = "nlopt:slsqp";
  const Result r = solve(bowl(), options);
  REQUIRE(r.stages.size() == 1);
  CHECK(r.stages[0].word.ends_with("_REACHED"));  // as NLopt names each of its criteria
}

TEST_CASE("a limit on one side leaves the other side open", "[optim][definition]") {
  for (const bool upper : {false, true}) {
    Problem p = bowl();
    Constraint limit;
    limit.name = "line";
    (upper ? limit.upper : limit.lower) = upper ? -1.0 : 1.0;
    p.constraints = {limit};
    const Result r = solve(p);
    CAPTURE(upper);
    CHECK(r.outcome == Outcome::optimal);
    CHECK(r.design[0] + r.design[1] ==
          Approx(upper ? -1.0 : 1.0).epsilon(1e-7));  // as SLSQP meets limits
  }
}
