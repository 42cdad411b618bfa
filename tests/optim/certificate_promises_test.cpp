// SPDX-License-Identifier: Apache-2.0
// Certificates where an optimum is not a plain one, and infeasible equalities.
#include "optim/bank/dual_problem.hpp"

#include <twum/optim/solve.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>

using namespace twum;
using namespace twum::optim;

namespace {

using D = Dual<double, 2>;
using Design = std::vector<double>;

Problem posed(std::size_t objectives, std::vector<Variable> variables,
              std::vector<Constraint> constraints, std::function<void(const D*, D*)> f) {
  Problem p;
  p.variables = std::move(variables);
  for (std::size_t k = 0; k < objectives; ++k) p.objectives.push_back({test::numbered('f', k)});
  p.constraints = std::move(constraints);
  p.evaluate = test::dual_evaluator<2>(p.responses(), std::move(f));
  return p;
}

}  // namespace

TEST_CASE("a concave kink never passes, whatever the Jacobian holds there",
          "[optim][certificate]") {
  for (const double entry : {-1.0, -0.5, 0.0, 0.5, 1.0}) {  // -|x|, top of a hill
    Problem p = posed(1, {{"x", -1.0, 1.0, 0.5}}, {}, [](const D* x, D* r) { r[0] = x[0]; });
    p.evaluate = [entry](std::span<const double> x, bool) {
      Evaluation e{{-std::abs(x[0])}, {x[0] == 0.0 ? entry : x[0] < 0.0 ? 1.0 : -1.0}, {}, {}};
      if (x[0] == 0.0) e.kinks.push_back({0, 0, Slope::one_sided, 1.0, -1.0});
      return e;
    };
    CAPTURE(entry);
    CHECK_FALSE(certify(p, Design{0.0}).passed);
  }
}

TEST_CASE("x^2 + c is not flat, whatever c", "[optim][certificate]") {
  for (const double c :
       {0.0, 2.0, 3.0}) {  // slope 2 at the start; c = 2 makes value times factor 1
    const Problem p =
        posed(1, {{"x", 0.0, 1.0, 1.0}}, {}, [c](const D* x, D* r) { r[0] = x[0] * x[0] + c; });
    CAPTURE(c);
    for (const Finding& f : certify(p, Design{0.0}).findings)
      CHECK(f.kind != Degeneracy::flat_objective);
  }
}

TEST_CASE("a curvature that was not tested is NaN", "[optim][certificate]") {
  const Problem p =
      posed(1, {{"x", -1.0, 1.0, 0.5}}, {}, [](const D* x, D* r) { r[0] = x[0] * x[0]; });
  SolveOptions few;
  few.budget.evaluations = 2;
  CHECK(std::isnan(certify(p, Design{1e-9}, few).curvature));
  CHECK(std::isnan(certify(p, Design{0.3}).curvature));
}

TEST_CASE("an equality missed from above pulls down", "[optim][certificate]") {
  // x = target, and two limits that ask for x >= 2: the sum of violations is smallest at 2 when the
  // target is 1. Its mirror image, which is said right, has the same answer.
  for (const double s : {1.0, -1.0}) {
    const double up = s > 0 ? kInfinity : -2.0, low = s > 0 ? 2.0 : -kInfinity;
    const Problem p =
        posed(1, {{"x", 0.0, 10.0, 5.0}}, {{"target", s, s}, {"a", low, up}, {"b", low, up}},
              [s](const D* x, D* r) { r[0] = x[0], r[1] = r[2] = r[3] = s * x[0]; });
    const Result r = solve(p);
    CAPTURE(s);
    REQUIRE(r.outcome == Outcome::infeasible);
    CHECK(r.infeasibility.design[0] == Approx(2.0));
    CHECK(r.infeasibility.certified);
    CHECK(r.infeasibility.conflict.size() >= 2);
  }
}

TEST_CASE("each point of a concave front is an optimum", "[optim][certificate]") {
  const Problem p = posed(2, {{"t", 0.0, 1.5, 0.5}}, {},
                          [](const D* x, D* r) { r[0] = cos(x[0]), r[1] = sin(x[0]); });
  for (const double t : {0.3, 0.7, 1.2}) CHECK(certify(p, Design{t}).passed);
}

TEST_CASE("the best weights do not depend on the order of the objectives", "[optim][certificate]") {
  for (const bool swapped : {false, true}) {
    const Problem p = posed(2, {{"x", -1.0, 1.0, 0.5}}, {}, [swapped](const D* x, D* r) {
      r[swapped ? 1 : 0] = x[0];
      r[swapped ? 0 : 1] = x[0] * x[0];
    });
    CAPTURE(swapped);  // weight 1 for x^2 leaves a slope of 2e-8
    CHECK(certify(p, Design{1e-8}).stationarity < 1e-6);
  }
}
