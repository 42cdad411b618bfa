// SPDX-License-Identifier: Apache-2.0
// Kinks of which one side alone is stationary, kinks on bounds, and kinks of large objectives.
#include "optim/bank/dual_problem.hpp"

#include <twum/optim/solve.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

using namespace twum;
using namespace twum::optim;

namespace {

// Of one variable: slopes `left` and `right` on the two sides of `place`, where it has the value 5 and tells
// both slopes. The Jacobian holds the right one there.
struct Bend {
  double place, left, right;
};

Problem bent(const Bend& bend, double lower, double upper, double start) {
  Problem p;
  p.variables = {{"x", lower, upper, start}};
  p.objectives = {{"f"}};
  p.evaluate = [bend](std::span<const double> x, bool) {
    const double t = x[0] - bend.place, slope = t < 0.0 ? bend.left : bend.right;
    Evaluation e{{5.0 + slope * t}, {slope}, {}, {}};
    if (t == 0.0) e.kinks.push_back({0, 0, Slope::one_sided, bend.left, bend.right});
    return e;
  };
  return p;
}

// With calls for the start and the bend and no more: what is told has to do.
Certificate at_bend(const Bend& bend, double lower, double upper, double start) {
  SolveOptions options;
  options.budget.evaluations = 2;
  return certify(bent(bend, lower, upper, start), std::vector<double>{bend.place}, options);
}

}  // namespace

TEST_CASE("a concave kink is as far from stationary as the worse of its sides",
          "[optim][certificate][kink][closed_form]") {
  // 5 + min(x, 0) is level on the right and falls to the left, as steeply as at the start; and its
  // mirror image.
  for (const auto& [bend, start] :
       {std::pair{Bend{0.0, 1.0, 0.0}, -0.5}, std::pair{Bend{0.0, 0.0, -1.0}, 0.5}}) {
    const Certificate c = at_bend(bend, -1.0, 1.0, start);
    CAPTURE(bend.left, bend.right, c.reason);
    CHECK_FALSE(c.passed);
    CHECK(c.stationarity == Approx(1.0).epsilon(1e-12));  // a quotient of two products
    CHECK(c.weights == std::vector<double>{1.0});
    REQUIRE(c.findings.size() == 1);
    CHECK(c.findings[0].kind == Degeneracy::kink);
  }
}

TEST_CASE("on a bound a kink has the side that is inside the box and no other",
          "[optim][certificate][kink]") {
  // |x - place|, least on the bound: the slope beyond it is nobody's.
  for (const double place : {0.0, 1.0}) {
    const Certificate c = at_bend({place, -1.0, 1.0}, 0.0, 1.0, 0.5);
    CAPTURE(place, c.reason);
    CHECK(c.passed);
    CHECK(c.stationarity < 1e-12);  // the bound's multiplier is the slope but for rounding
  }
  // And -|x - place|, largest there: the side inside falls.
  for (const double place : {0.0, 1.0}) {
    const Certificate c = at_bend({place, 1.0, -1.0}, 0.0, 1.0, 0.5);
    CAPTURE(place);
    CHECK_FALSE(c.passed);
    CHECK(c.stationarity == Approx(1.0).epsilon(1e-12));
  }
}

TEST_CASE("a kink that nobody tells is found in a large objective too",
          "[optim][certificate][kink]") {
  // level + 3 |x| + (y^2 - x^2) / 10 has its minimum at the origin. A step of 1e-7 of the box, which is
  // 2 wide, raises it by 6e-7, 300 times the rounding of 1e7.
  using D = Dual<double, 2>;
  for (const double level : {5.0, 1e7, -1e7}) {
    Problem p;
    p.variables = test::box(2, -1.0, 1.0, {0.5, 0.5});
    p.objectives = {{"f"}};
    p.evaluate = test::dual_evaluator<2>(1, [level](const D* x, D* r) {
      const D size = x[0].v < 0.0 ? -x[0] : x[0];
      r[0] = level + 3.0 * size + 0.1 * (x[1] * x[1] - x[0] * x[0]);
    });
    const Certificate c = certify(p, std::vector<double>{0.0, 0.0});
    CAPTURE(level, c.reason);
    CHECK(c.passed);
    REQUIRE(c.findings.size() == 1);
    CHECK(c.findings[0].kind == Degeneracy::kink);
    CHECK(c.findings[0].names == std::vector<std::string>{"x1"});
  }
}

TEST_CASE("on a bound a kink has one side, and nothing need be told of the other",
          "[optim][certificate][closed_form]") {
  // f = x in [0, 1], told as a kink at either end: least at 0, and greatest at 1.
  const double nothing = std::nan("");
  for (const bool maximize : {false, true}) {
    Problem p;
    p.variables = test::box(1, 0.0, 1.0, {0.5});
    p.objectives = {{"f", maximize ? Sense::maximize : Sense::minimize}};
    p.evaluate = [=](std::span<const double> x, bool) {
      Evaluation e{{x[0]}, {1.0}, {}, {}};
      e.kinks = {{0, 0, Slope::one_sided, x[0] > 0.0 ? 1.0 : nothing, x[0] < 1.0 ? 1.0 : nothing}};
      return e;
    };
    const double best = maximize ? 1.0 : 0.0;
    CAPTURE(maximize);
    CHECK(certify(p, std::vector<double>{best}).passed);
    CHECK_FALSE(certify(p, std::vector<double>{1.0 - best}).passed);
    const Certificate inside = certify(p, std::vector<double>{0.5});
    CHECK_FALSE(inside.passed);
    // Inside both sides count, and one that is no number tells nothing.
    p.evaluate = [=](std::span<const double>, bool) {
      return Evaluation{{0.0}, {0.0}, {{0, 0, Slope::one_sided, nothing, 1.0}}, {}};
    };
    CHECK_FALSE(certify(p, std::vector<double>{0.5}).passed);
  }
}
