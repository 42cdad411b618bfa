// SPDX-License-Identifier: Apache-2.0
// What a certificate reports about limits: sides, values, and the gain if a limit is loosened by one unit or one
// per cent, for functions where all of it is known by hand.
#include "optim/bank/dual_problem.hpp"

#include <twum/optim/solve.hpp>

#include <catch2/catch.hpp>

#include <cmath>

using namespace twum;
using namespace twum::optim;

namespace {

using D = Dual<double, 8>;

// Quotients and products of a few numbers, and least squares with one unknown to each equation.
constexpr double kRounding = 1e-12;
constexpr double kUnit = 1e-3;  // of the objective

struct Expected {
  const char* name;
  bool bound;
  Side side;
  double value, limit, multiplier, percent;  // percent: what one percent of the limit is
};

// The sum of slope times variable. Each variable is held by a bound of its own, or by a limit.
constexpr double kSlopes[] = {3.0, -2.0, 7.0, -0.5, 1.0, 6.0, -4.0, 3.0};
const std::vector<double> kCorner{2.0, 0.0, 0.1, 8.0, -1.0, 1.5, 0.5, 0.0};

Problem corner(bool maximize) {
  Problem p;
  p.variables = {{"low", 2.0, 10.0, 5.0},
                 {"zero", -5.0, 0.0, -2.0},
                 {"log low", 0.1, 40.0, 3.0, Scale::log},
                 {"log high", 1.0, 8.0, 2.0, Scale::log},
                 {"negative", -1.0, 4.0, 1.0},
                 {"x6", -3.0, 9.0, 2.0},
                 {"x7", -3.0, 2.0, 0.0},
                 {"x8", -2.0, 6.0, 1.0}};
  p.objectives = {{"f", maximize ? Sense::maximize : Sense::minimize}};
  p.constraints = {
      {"floor", 1.5}, {"one", -kInfinity, 1.0}, {"flat", 0.0}, {"inactive", -60.0, 50.0}};
  const double unit = maximize ? -kUnit : kUnit;
  p.evaluate = test::dual_evaluator<8>(5, [unit](const D* x, D* r) {
    r[0] = D(0.0);
    for (int i = 0; i < 8; ++i) r[0] = r[0] + unit * kSlopes[i] * x[i];
    r[1] = x[5];
    r[2] = 2.0 * x[6];
    r[3] = 0.5 * x[7];
    r[4] = 11.0 * x[0] + x[7];
  });
  return p;
}

// A variable moves by the limit's step over its factor in the limit. A limit of zero is loosened by
// 1 % of what its response spans: the box for a bound, 0.5 times 8 for "flat".
const std::vector<Expected> kExpected{{"floor", false, Side::lower, 1.5, 1.5, 6.0, 0.015},
                                      {"one", false, Side::upper, 1.0, 1.0, 2.0, 0.01},
                                      {"flat", false, Side::lower, 0.0, 0.0, 6.0, 0.04},
                                      {"inactive", false, Side::lower, 22.0, -60.0, 0.0, 0.6},
                                      {"inactive", false, Side::upper, 22.0, 50.0, 0.0, 0.5},
                                      {"low", true, Side::lower, 2.0, 2.0, 3.0, 0.02},
                                      {"zero", true, Side::upper, 0.0, 0.0, 2.0, 0.05},
                                      {"log low", true, Side::lower, 0.1, 0.1, 7.0, 0.001},
                                      {"log high", true, Side::upper, 8.0, 8.0, 0.5, 0.08},
                                      {"negative", true, Side::lower, -1.0, -1.0, 1.0, 0.01}};

void check(const Activity& a, const Expected& e, double sign) {
  CAPTURE(e.name, a.name);
  CHECK(a.name == e.name);
  CHECK(a.is_bound == e.bound);
  CHECK(a.side == e.side);
  CHECK(a.value == Approx(e.value).epsilon(kRounding));
  CHECK(a.limit == e.limit);
  CHECK(a.violation == 0.0);
  CHECK(a.active == (e.multiplier > 0.0));
  CHECK(a.multiplier == Approx(kUnit * e.multiplier).epsilon(kRounding));
  CHECK(a.gain_per_percent == Approx(sign * kUnit * e.multiplier * e.percent).epsilon(kRounding));
}

// a (x - centre)^2 with 3 x = 6.
Certificate held(double a, double centre, bool maximize) {
  Problem p;
  p.variables = test::box(1, -3.0, 8.0, {1.0});
  p.objectives = {{"f", maximize ? Sense::maximize : Sense::minimize}};
  p.constraints = {{"six", 6.0, 6.0}};
  p.evaluate = test::dual_evaluator<8>(2, [=](const D* x, D* r) {
    r[0] = a * (x[0] - centre) * (x[0] - centre);
    r[1] = 3.0 * x[0];
  });
  return certify(p, std::vector{2.0});
}

// 2 x + y wanted small and x - 2 y wanted large, or their negatives the other way round, with
// x + y >= 1: moving along that limit, each is traded for the other.
Certificate opposed(Sense sense) {
  const double sign = sense == Sense::maximize ? -1.0 : 1.0;
  Problem p;
  p.variables = test::box(2, -5.0, 5.0, {2.0, 3.0});
  const bool largest = sense == Sense::maximize;
  p.objectives = {{"f", sense}, {"g", largest ? Sense::minimize : Sense::maximize}};
  p.constraints = {{"sum", 1.0}};
  p.evaluate = test::dual_evaluator<8>(3, [sign](const D* x, D* r) {
    r[0] = sign * (2.0 * x[0] + x[1]);
    r[1] = sign * (x[0] - 2.0 * x[1]);
    r[2] = x[0] + x[1];
  });
  return certify(p, std::vector{0.5, 0.5});
}

}  // namespace

TEST_CASE("limits and bounds of a linear problem have its slopes for multipliers",
          "[optim][certificate][closed_form]") {
  const bool maximize = GENERATE(false, true);
  const Certificate c = certify(corner(maximize), kCorner);
  CAPTURE(maximize, c.reason);
  CHECK(c.passed);
  REQUIRE(c.limits.size() == kExpected.size());
  for (std::size_t i = 0; i < c.limits.size(); ++i)
    check(c.limits[i], kExpected[i], maximize ? 1.0 : -1.0);
}

TEST_CASE("a raised target of an equality helps or harms as the objective's slope says",
          "[optim][certificate][closed_form]") {
  const bool maximize = GENERATE(false, true);
  for (const double centre : {0.0, 5.0, -1.0}) {
    for (const double a : {1.0, -0.01}) {
      const double slope = a * 2.0 * (2.0 - centre) / 3.0;  // for each unit of the target
      const Certificate c = held(a, centre, maximize);
      CAPTURE(maximize, centre, a);
      REQUIRE(c.limits.size() == 1);
      CHECK(c.limits[0].side == Side::equal);
      CHECK(c.limits[0].multiplier == Approx(maximize ? slope : -slope).epsilon(kRounding));
      CHECK(c.limits[0].gain_per_percent == Approx(0.06 * slope).epsilon(kRounding));
    }
  }
}

TEST_CASE("broken limits are broken by what is missing in their own unit",
          "[optim][certificate][closed_form]") {
  Problem p;
  p.variables = test::box(2, -5.0, 5.0, {2.0, 3.0});
  p.objectives = {{"f"}};
  p.constraints = {{"low", 20.0, 90.0}, {"high", -kInfinity, -0.5}, {"same", 3.0, 3.0}};
  p.evaluate = test::dual_evaluator<8>(4, [](const D* x, D* r) {
    r[0] = x[0] + 100.0 * x[1];
    r[1] = 12.0 * x[0];
    r[2] = 0.25 * x[1];
    r[3] = x[0] + x[1];
  });
  const Certificate c = certify(p, std::vector{1.0, 4.0});
  CHECK_FALSE(c.passed);
  const std::vector<double> limits{20.0, 90.0, -0.5, 3.0}, values{12.0, 12.0, 1.0, 5.0};
  const std::vector<double> missing{8.0, 0.0, 1.5, 2.0};
  REQUIRE(c.limits.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    CAPTURE(i);
    CHECK(c.limits[i].value == Approx(values[i]).epsilon(kRounding));
    CHECK(c.limits[i].limit == limits[i]);
    CHECK(c.limits[i].violation == Approx(missing[i]).epsilon(kRounding));
  }
}

TEST_CASE("what a looser limit gains is a change towards the better side of the first objective",
          "[optim][certificate][pareto]") {
  // Less room for x + y moves f down and, where it is to be large, up.
  const Certificate least = opposed(Sense::minimize), most = opposed(Sense::maximize);
  REQUIRE(least.passed);
  REQUIRE(most.passed);
  CHECK(least.limits[0].multiplier > 0.0);
  CHECK(least.limits[0].gain_per_percent < 0.0);
  CHECK(most.limits[0].gain_per_percent == -least.limits[0].gain_per_percent);
}

TEST_CASE("of limits that meet from both sides only the one that holds has a multiplier",
          "[optim][certificate][closed_form]") {
  for (const bool floor_first : {true, false}) {
    const Constraint floor{"floor", 1.0}, ceiling{"ceiling", -kInfinity, 1.0};
    Problem p;
    p.variables = test::box(2, -5.0, 5.0, {2.0, 3.0});
    p.objectives = {{"f"}};
    p.constraints = {floor_first ? floor : ceiling, floor_first ? ceiling : floor};
    p.evaluate = test::dual_evaluator<8>(3, [](const D* x, D* r) {
      r[0] = 4.0 * x[0] + x[1] * x[1];
      r[1] = r[2] = x[0];
    });
    const Certificate c = certify(p, std::vector{1.0, 0.0});
    CHECK(c.passed);
    CHECK(c.limits[floor_first ? 0 : 1].multiplier == Approx(4.0).epsilon(kRounding));
    CHECK(c.limits[floor_first ? 1 : 0].multiplier == 0.0);
  }
}
