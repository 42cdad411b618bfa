// SPDX-License-Identifier: Apache-2.0
// Functions without derivatives.
#include <twum/base/error.hpp>
#include <twum/optim/certify.hpp>
#include <twum/optim/pareto.hpp>
#include <twum/optim/solve.hpp>
#include <twum/optim/solvers.hpp>

#include <catch2/catch.hpp>

using namespace twum;
using namespace twum::optim;
using Catch::Contains;

namespace {

// (x - 1)^2 + (y + 1)^2 on [-2, 2]^2, with y >= at_least.
Problem black_box(double at_least) {
  Problem p;
  p.variables = {{.name = "x", .lower = -2, .upper = 2}, {.name = "y", .lower = -2, .upper = 2}};
  p.objectives = {{.name = "f"}};
  p.constraints = {{.name = "y", .lower = at_least}};
  p.derivatives = false;
  p.evaluate = [](std::span<const double> x, bool gradient) {
    CHECK(!gradient);
    return Evaluation{.values = {(x[0] - 1) * (x[0] - 1) + (x[1] + 1) * (x[1] + 1), x[1]}};
  };
  return p;
}

SolveOptions cobyla() {
  SolveOptions options;
  options.solver = "nlopt:cobyla";
  return options;
}

}  // namespace

TEST_CASE("a function without derivatives is solved, and its certificate is not measured",
          "[optim][derivatives]") {
  const Result r = solve(black_box(0.5), cobyla());
  CHECK(r.outcome == Outcome::feasible);
  REQUIRE(r.design.size() == 2);
  // The limit is active: f = (x - 1)^2 + 2.25. COBYLA ends at a relative accuracy of x far below 1e-4.
  CHECK(r.design[0] == Approx(1).margin(1e-4));
  CHECK(r.design[1] == Approx(0.5).margin(1e-6));
  CHECK(!r.certificate.passed);
  CHECK(r.certificate.reason == "not measured: the problem gives no derivatives");
  CHECK(r.evaluation.jacobian.empty());
}

TEST_CASE("limits that no design keeps are found without derivatives, but not explained",
          "[optim][derivatives]") {
  const Result r = solve(black_box(3), cobyla());
  CHECK(r.outcome == Outcome::infeasible);
  CHECK(r.infeasibility.relaxations.empty());
}

TEST_CASE("what needs derivatives refuses a problem without", "[optim][derivatives]") {
  for (const char* solver : {"auto", "nlopt:slsqp"}) {
    SolveOptions options;
    options.solver = solver;
    CHECK_THROWS_AS(solve(black_box(0), options), InputError);
    CHECK_THROWS_WITH(solve(black_box(0), options), Contains("needs derivatives"));
  }
  Problem two = black_box(0);
  two.objectives.push_back({.name = "g"});
  CHECK_THROWS_WITH(pareto_front(two), Contains("derivatives"));
  CHECK_THROWS_WITH(certify(black_box(0), std::vector<double>{0, 0}), Contains("derivatives"));
}
