// SPDX-License-Identifier: Apache-2.0
// Options of a solve that have no meaning are refused by name.
#include <twum/base/error.hpp>
#include <twum/optim/pareto.hpp>
#include <twum/optim/solve.hpp>

#include <catch2/catch.hpp>

#include <cmath>

using namespace twum;
using namespace twum::optim;
using Catch::Contains;

namespace {

Problem bowl() {
  Problem p;
  p.variables = {{.name = "x", .lower = -2, .upper = 2}};
  p.objectives = {{.name = "f"}};
  p.evaluate = [](std::span<const double> x, bool) {
    return Evaluation{.values = {x[0] * x[0]}, .jacobian = {2 * x[0]}, .kinks = {}, .failure = {}};
  };
  return p;
}

void check_refused(const std::string& name, void (*spoil)(SolveOptions&)) {
  SolveOptions options;
  spoil(options);
  CHECK_THROWS_WITH(solve(bowl(), options), Contains(name));
  CHECK_THROWS_AS(solve(bowl(), options), InputError);
  CHECK_THROWS_AS(validate(options), InputError);
}

}  // namespace

TEST_CASE("an option without a meaning is refused by its name", "[optim]") {
  check_refused("tolerance: -1", [](SolveOptions& o) { o.tolerance = -1; });
  check_refused("tolerance: nan", [](SolveOptions& o) { o.tolerance = std::nan(""); });
  check_refused("tolerance: 1", [](SolveOptions& o) { o.tolerance = 1; });
  check_refused("feasibility_tolerance", [](SolveOptions& o) { o.feasibility_tolerance = -1; });
  check_refused("feasibility_tolerance", [](SolveOptions& o) { o.feasibility_tolerance = NAN; });
  check_refused("budget.seconds", [](SolveOptions& o) { o.budget.seconds = -1; });
  check_refused("budget.seconds", [](SolveOptions& o) { o.budget.seconds = NAN; });
}

TEST_CASE("an option that the solver would ignore is refused", "[optim]") {
  check_refused("solver_options", [](SolveOptions& o) {
    o.solver_options = {{"ftol_rel", "1e-9"}};
  });
  check_refused("global", [](SolveOptions& o) {
    o.solver = "nlopt:slsqp";
    o.global = "nlopt:isres";
  });
}

TEST_CASE("a front checks the options of its solves", "[optim]") {
  Problem p = bowl();
  p.objectives.push_back({.name = "g"});
  ParetoOptions options;
  options.solve.tolerance = -1;
  CHECK_THROWS_WITH(pareto_front(p, options), Contains("tolerance"));
}
