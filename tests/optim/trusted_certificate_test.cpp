// SPDX-License-Identifier: Apache-2.0
// Problems whose start, box or weakly active limits lead to answers that look certain and are not.
#include "optim/bank/posed.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <twum/optim/solve.hpp>

using namespace twum;
using namespace twum::optim;

namespace {

using D = Dual<double, 3>;
using Design = std::vector<double>;

D cubed(const D& x) { return x * x * x; }

Result solved(const Problem& p, const std::string& solver = "auto") {
  SolveOptions options;
  options.solver = solver;
  return solve(p, options);
}

// As published: -1 at (0, 1).
Problem hs10(double width) {
  return test::posed<3>({{"x1", -width, width, -10.0}, {"x2", -width, width, 10.0}},
                        {{"c1", -1.0, kInfinity}}, [](const D* x, D* r) {
                          r[0] = x[0] - x[1];
                          r[1] = -3.0 * x[0] * x[0] + 2.0 * x[0] * x[1] - x[1] * x[1];
                        });
}

const std::vector<std::string> kSolvers{"auto", "nlopt:slsqp", "ipopt"};

bool absent(const std::string& solver) {
  return solver == "ipopt" && !find_solver("ipopt").available;
}

}  // namespace

TEST_CASE("a limit is kept in its own units, however steep the start was (O2.1)",
          "[optim][certificate][closed_form]") {
  const Problem stress = test::posed<3>({{"x", 1e-3, 10.0, 1e-3}}, {{"stress", -kInfinity, 8.0}},
                                        [](const D* x, D* r) {
                                          r[0] = x[0];
                                          r[1] = 1.0 / cubed(x[0]);
                                        });
  const Problem steep =
      test::posed<3>({{"x", -20.0, 20.0, 20.0}}, {{"c", 1.0, kInfinity}}, [](const D* x, D* r) {
        r[0] = x[0];
        r[1] = exp(x[0]);
      });
  for (const std::string& solver : kSolvers) {
    if (absent(solver)) continue;
    CAPTURE(solver);
    const Result half = solved(stress, solver), zero = solved(steep, solver);
    CHECK(half.outcome == Outcome::optimal);
    // 1e-8 of the terms of the stress, 24, over its slope 48.
    CHECK(half.design[0] == Approx(0.5).margin(5e-9));
    CHECK(zero.outcome == Outcome::optimal);
    CHECK(zero.design[0] == Approx(0.0).margin(1e-8));
  }
}

TEST_CASE("an own tolerance is what a limit may be broken by", "[optim][certificate]") {
  for (const double tolerance : {1e-3, 1e-6, 0.0}) {
    Problem p = test::posed<3>({{"x", 0.0, 10.0, 5.0}}, {{"c", 1.0, kInfinity}},
                               [](const D* x, D* r) { r[0] = r[1] = x[0]; });
    p.constraints[0].tolerance = tolerance;
    for (const double part : {0.9, 1.1}) {
      const Certificate c = certify(p, Design{1.0 - part * tolerance});
      CAPTURE(tolerance, part);
      REQUIRE(c.limits.size() == 1);
      CHECK(c.limits[0].tolerance == tolerance);
      if (tolerance > 0.0) CHECK((c.reason == "a constraint is violated") == (part > 1.0));
    }
  }
}

TEST_CASE("limits that contradict each other by a thousandth do so in a box of a million",
          "[optim][infeasible]") {
  const Problem p =
      test::posed<3>({{"x", -1e6, 1e6}}, {{"ge", 1.0, kInfinity}, {"le", -kInfinity, 0.999}},
                     [](const D* x, D* r) {
                       r[0] = x[0] * x[0];
                       r[1] = r[2] = x[0];
                     });
  for (const std::string& solver : kSolvers)
    if (!absent(solver)) CHECK(solved(p, solver).outcome == Outcome::infeasible);
}

TEST_CASE("limits with multiplier zero are not taken as held (O4.1)",
          "[optim][certificate][closed_form]") {
  const Problem saddle = test::posed<3>({{"x", 0.0, 2.0, 0.0}, {"y", 0.0, 2.0, 0.0}}, {},
                                        [](const D* x, D* r) { r[0] = -(x[0] * x[1]); });
  CHECK_FALSE(certify(saddle, Design{0.0, 0.0}).passed);
  CHECK(certify(saddle, Design{2.0, 2.0}).passed);
  CHECK(solved(saddle, "nlopt:slsqp").evaluation.values[0] == Approx(-4.0).epsilon(1e-12));
  const Problem mixed = test::posed<3>(
      {{"x", 0.0, 2.0}, {"y", 0.0, 2.0}}, {},
      [](const D* x, D* r) { r[0] = x[0] * x[0] - 3.0 * x[0] * x[1] + x[1] * x[1]; });
  CHECK_FALSE(certify(mixed, Design{0.0, 0.0}).passed);
  const Problem limited = test::posed<3>({{"x", -2.0, 2.0}, {"y", -2.0, 2.0}, {"z", 0.0, 1.0}},
                                         {{"cx", 0.0}, {"cy", 0.0}}, [](const D* x, D* r) {
                                           r[0] = x[2] - x[0] * x[1];
                                           r[1] = x[0];
                                           r[2] = x[1];
                                         });
  CHECK_FALSE(certify(limited, Design{0.0, 0.0, 0.0}).passed);
  // With the sign turned the same corner is an optimum, and decided.
  const Problem turned = test::posed<3>({{"x", 0.0, 2.0}, {"y", 0.0, 2.0}}, {},
                                        [](const D* x, D* r) { r[0] = x[0] * x[1]; });
  const Certificate corner = certify(turned, Design{0.0, 0.0});
  CHECK(corner.passed);
  CHECK(corner.second_order);
}

TEST_CASE("a flat direction is followed a little way before a design is called an optimum",
          "[optim][certificate][closed_form]") {
  // x^3 at 0, and Peano's (y - x^2)(y - 2 x^2), which rises along every line but falls on y = 1.5 x^2.
  const Problem inflection =
      test::posed<3>({{"x", -1.0, 1.0}}, {}, [](const D* x, D* r) { r[0] = cubed(x[0]); });
  CHECK_FALSE(certify(inflection, Design{0.0}).passed);
  const Problem peano = test::posed<3>(
      {{"x", -1.0, 1.0}, {"y", -1.0, 1.0}}, {},
      [](const D* x, D* r) { r[0] = (x[1] - x[0] * x[0]) * (x[1] - 2.0 * x[0] * x[0]); });
  CHECK_FALSE(certify(peano, Design{0.0, 0.0}).passed);
  const Problem fourth = test::posed<3>({{"x", -1.0, 1.0}}, {},
                                        [](const D* x, D* r) { r[0] = x[0] * x[0] * x[0] * x[0]; });
  CHECK(certify(fourth, Design{0.0}).passed);
  CHECK(certify(fourth, Design{0.0}).second_order);
}

TEST_CASE("what curvature and values leave open is optimal to first order only (O4.1)",
          "[optim][certificate][closed_form]") {
  // The floor of a valley; a maximum that nothing shows within a tenth of a unit; two directions without curvature, on
  // whose diagonal the last of them falls.
  const auto square = [](const D& x) { return x * x; };
  const auto of_two = [](auto f) {
    return test::posed<3>({{"x", -1.0, 1.0}, {"y", -1.0, 1.0}}, {},
                          [f](const D* x, D* r) { r[0] = f(x[0], x[1]); });
  };
  const auto twelfth = [square](const D& x) { return square(cubed(square(x))); };
  const std::vector<Problem> open{
      of_two([=](const D& x, const D& y) { return square(x + y); }),
      of_two([=](const D& x, const D& y) { return 1.0 + square(y) - twelfth(x); }),
      of_two([=](const D& x, const D& y) { return square(square(x)) + square(square(y)); }),
      of_two([=](const D& x, const D& y) {
        return square(square(x)) + square(square(y)) - 3.0 * square(x) * square(y);
      })};
  for (const Problem& p : open) CHECK_FALSE(certify(p, Design{0.0, 0.0}).second_order);
  for (std::size_t i = 0; i < 3; ++i) CHECK(certify(open[i], Design{0.0, 0.0}).passed);
}

TEST_CASE("an infinite slope into a bound holds the variable, one to the inside does not",
          "[optim][certificate][closed_form]") {
  for (const double sign : {1.0, -1.0}) {
    Problem p;
    p.variables = {{"x", 0.0, 1.0, 0.5}, {"y", 0.0, 1.0, 0.2}};
    p.objectives = {{"f", sign > 0.0 ? Sense::minimize : Sense::maximize}};
    p.evaluate = [=](std::span<const double> x, bool) {
      const double t = x[1] - 0.5, root = std::sqrt(x[0]);
      Evaluation e;
      e.values = {sign * (root + t * t - x[0])};
      e.jacobian = {sign * (0.5 / root - 1.0), sign * 2.0 * t};
      return e;
    };
    CHECK(certify(p, Design{0.0, 0.5}).passed);
    CHECK_FALSE(certify(p, Design{0.0, 0.4}).passed);  // the other variable is not optimal
    p.objectives[0].sense = sign > 0.0 ? Sense::maximize : Sense::minimize;
    CHECK_FALSE(certify(p, Design{0.0, 0.5}).passed);
  }
  // Both goals want x = 0, one of them infinitely much; their compromise is in y.
  Problem both;
  both.variables = {{"x", 0.0, 1.0}, {"y", 0.0, 1.0}};
  both.objectives = {{"f"}, {"g"}};
  both.evaluate = [](std::span<const double> x, bool) {
    Evaluation e;
    e.values = {x[1] * x[1] + x[0], (x[1] - 1.0) * (x[1] - 1.0) + std::pow(x[0], 0.25)};
    e.jacobian = {1.0, 2.0 * x[1], 0.25 * std::pow(x[0], -0.75), 2.0 * (x[1] - 1.0)};
    return e;
  };
  CHECK(certify(both, Design{0.0, 0.3}).passed);
}

TEST_CASE("a steep start makes no design stationary (O3.2, O3.3)", "[optim][certificate]") {
  const Problem valley = test::posed<3>({{"x", -100.0, 100.0, -100.0}, {"y", -100.0, 100.0, 100.0}},
                                        {}, [](const D* x, D* r) {
                                          const D bend = x[1] - x[0] * x[0], rest = 1.0 - x[0];
                                          r[0] = 100.0 * bend * bend + rest * rest;
                                        });
  for (const char* solver : {"auto", "ipopt", "nlopt:cobyla", "nlopt:lbfgs", "nlopt:mma",
                             "nlopt:tnewton_precond_restart", "nlopt:var2", "nlopt:ccsaq"}) {
    if (absent(solver)) continue;
    const Result r = solved(valley, solver);
    CAPTURE(solver, r.evaluation.values[0]);
    CHECK((!r.certificate.passed || r.evaluation.values[0] < 1e-12));
  }
  CHECK(solved(valley).outcome == Outcome::optimal);
  const Problem wall = test::posed<3>({{"x", -2.0, 2.0, 2.0}}, {}, [](const D* x, D* r) {
    const D t = x[0] + 1.5;
    r[0] = exp(20.0 * x[0]) + t * t;
  });
  // exp(-30) moves the least value away from -1.5 by 10 exp(-30) = 1e-12.
  for (const char* solver : {"auto", "nlopt:slsqp", "nlopt:lbfgs"})
    CHECK(solved(wall, solver).design[0] == Approx(-1.5).margin(1e-9));
}

TEST_CASE("an answer does not depend on the width of a box that does not bind",
          "[optim][certificate]") {
  for (const double width : {20.0, 1e3, 1e5, 1e10}) {
    const Result r = solved(hs10(width));
    CAPTURE(width);
    CHECK(r.outcome == Outcome::optimal);
    CHECK(r.evaluation.values[0] == Approx(-1.0).epsilon(1e-9));
    const Problem sphere =
        test::posed<3>({{"x", -width, width, 1.0}, {"y", -width, width, 1.0}}, {},
                       [](const D* x, D* r) { r[0] = (x[0] - 3.0) * (x[0] - 3.0) + x[1] * x[1]; });
    const Result s = solved(sphere);
    CHECK(s.outcome == Outcome::optimal);
    CHECK(s.design[0] == Approx(3.0).epsilon(1e-9));
    CHECK(s.certificate.findings.empty());
  }
}

TEST_CASE("what is known of degenerate limits is told", "[optim][certificate][infeasible]") {
  const Problem fixed =
      test::posed<3>({{"x", 1.0, 1.0}, {"y", 1.0, 1.0}}, {{"c", 3.0, 5.0}}, [](const D* x, D* r) {
        r[0] = x[0];
        r[1] = x[0] + x[1];
      });
  const Result far = solved(fixed);
  REQUIRE(far.infeasibility.relaxations.size() == 1);
  CHECK(far.infeasibility.relaxations[0].amount == 1.0);
  CHECK(far.infeasibility.relaxations[0].amount_alone == 1.0);
  // The same equality three times.
  const Problem repeated =
      test::posed<3>({{"x", -5.0, 5.0, 3.0}, {"y", -5.0, 5.0, 2.0}},
                     {{"a", 2.0, 2.0}, {"b", 4.0, 4.0}, {"c", 2.0, 2.0}}, [](const D* x, D* r) {
                       r[0] = x[0] * x[0] + x[1] * x[1];
                       r[1] = r[3] = x[0] + x[1];
                       r[2] = 2.0 * (x[0] + x[1]);
                     });
  for (const char* solver : {"auto", "ipopt"}) {
    if (absent(solver)) continue;
    const Result r = solved(repeated, solver);
    CAPTURE(solver);
    CHECK(r.outcome == Outcome::optimal);
    CHECK(r.evaluation.values[0] == Approx(2.0).epsilon(1e-9));
  }
  // A cusp: no multipliers exist at (1, 0), and no point beside it may be certified.
  const Problem cusp = test::posed<3>({{"x", 0.0, 10.0, 0.5}, {"y", 0.0, 10.0, 0.5}}, {{"c", 0.0}},
                                      [](const D* x, D* r) {
                                        const D t = x[0] - 2.0;
                                        r[0] = t * t + x[1] * x[1];
                                        r[1] = cubed(1.0 - x[0]) - x[1];
                                      });
  for (const std::string& solver : kSolvers) {
    if (absent(solver)) continue;
    const Result r = solved(cusp, solver);
    CAPTURE(solver, r.evaluation.values[0]);
    CHECK_FALSE(r.certificate.passed);
    CHECK(r.outcome == Outcome::feasible);
  }
  const Certificate tip = certify(cusp, Design{1.0, 0.0});
  CHECK_FALSE(tip.passed);
  CHECK(tip.reason.starts_with("no multipliers balance the slope"));
  REQUIRE(!tip.findings.empty());
  CHECK(tip.findings[0].kind == Degeneracy::dependent_constraints);
}

TEST_CASE("where limits follow from others, each is worth what it brings if it alone is loosened",
          "[optim][certificate][closed_form]") {
  // The largest x + 2 y over the box is at (0.5, 1) for y <= 1 + e and x + y <= 1.5: loosening c by e moves x by e. Nothing moves if
  // only y or x may go farther, as c or the other end holds it.
  const Problem vertex = test::posed<3>({{"x", 0.5, 3.0}, {"y", 0.0, 1.0}},
                                        {{"c", -kInfinity, 1.5}}, [](const D* x, D* r) {
                                          r[0] = -x[0] - 2.0 * x[1];
                                          r[1] = x[0] + x[1];
                                        });
  // The same limit twice, and one beside it that is worth 2 by itself.
  const Problem twice = test::posed<3>(
      {{"x", 0.0, 9.0}, {"y", 0.0, 9.0}},
      {{"a", 1.0, kInfinity}, {"b", 2.0, kInfinity}, {"c", 1.0, kInfinity}}, [](const D* x, D* r) {
        r[0] = x[0] + 2.0 * x[1], r[1] = x[0], r[2] = 2.0 * x[0], r[3] = x[1];
      });
  const auto worth = [](const Certificate& c, const std::string& name) {
    for (const Activity& a : c.limits)
      if (a.name == name && a.active) return a.multiplier;
    return -1.0;
  };
  const auto named = [](const Certificate& c) {
    return c.findings.empty() ? std::vector<std::string>{} : c.findings.front().names;
  };
  const Certificate one = certify(vertex, Design{0.5, 1.0});
  CHECK(one.passed);
  CHECK(worth(one, "c") == Approx(1.0).epsilon(1e-6));
  CHECK(worth(one, "x") == 0.0);
  CHECK(worth(one, "y") == 0.0);
  CHECK(named(one) == std::vector<std::string>{"c", "x", "y"});
  const Certificate two = certify(twice, Design{1.0, 1.0});
  CHECK(two.passed);
  CHECK(worth(two, "a") == 0.0);
  CHECK(worth(two, "b") == 0.0);
  CHECK(worth(two, "c") == Approx(2.0).epsilon(1e-6));
  CHECK(named(two) == std::vector<std::string>{"a", "b"});
}

TEST_CASE("a large slope or curvature in one variable hides no gain of both goals in another",
          "[optim][certificate][pareto][closed_form]") {
  for (const double large : {1e4, 1e7, 1e9}) {
    Problem curved;
    curved.variables = {{"x", 0.0, 1.0}, {"y", -1.0, 1.0}};
    curved.objectives = {{"f"}, {"g"}};
    curved.evaluate = [large](std::span<const double> x, bool) {
      const double t = x[1] - 1.0;
      Evaluation e;
      e.values = {x[0] + large * x[1] * x[1], x[0] + t * t};
      e.jacobian = {1.0, 2.0 * large * x[1], 1.0, 2.0 * t};
      return e;
    };
    Problem steep = curved;
    steep.constraints = {{"c", 0.0}};
    steep.evaluate = [large](std::span<const double> x, bool) {
      Evaluation e;
      e.values = {x[0] + large * x[1], x[0] + 2.0 * large * x[1], x[1]};
      e.jacobian = {1.0, large, 1.0, 2.0 * large, 0.0, 1.0};
      return e;
    };
    for (const Problem& p : {curved, steep}) {
      CHECK_FALSE(certify(p, Design{0.5, 0.0}).passed);
      CHECK(certify(p, Design{0.0, 0.0}).passed);
    }
  }
}
