// SPDX-License-Identifier: Apache-2.0
#include "curve/speed_roots.hpp"
#include "random_contact.hpp"

#include <twum/base/error.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

using namespace twum;
using namespace twum::core;
using namespace twum::test;

namespace {

using Function = std::function<double(double)>;

Bracket closed_in(const Function& f, double low, double high) {
  return close_in(f, {low, high, f(low), f(high)});
}

// x(f) = zero + f / slope + bend f^2 + twist f^3, which has its zero where it says. f(x) by Newton's method from
// f = 0, where x(f) is nearly straight.
struct Inverse {
  double zero, slope, bend, twist;
  double x(double f) const { return zero + f / slope + f * f * (bend + twist * f); }
  double f(double at) const {
    double f = 0;
    for (int i = 0; i < 60; ++i) f -= (x(f) - at) / (1 / slope + f * (2 * bend + 3 * twist * f));
    return f;
  }
};

}  // namespace

TEST_CASE("closing in ends at neighbouring numbers or at an exact zero",
          "[core][metrics][closed_form]") {
  const struct {
    Function f;
    double low, high, zero;
  } cases[] = {{[](double x) { return 1 - x; }, 0, 3, 1},
               {[](double x) { return x - 1; }, 0, 2, 1},
               {[](double x) { return x - 0.5; }, 0, 1, 0.5},
               {[](double x) { return x * x - 2; }, 1, 2, std::sqrt(2.0)},
               {[](double x) { return 2 - x * x; }, 1, 2, std::sqrt(2.0)}};
  for (const auto& each : cases) {
    const Bracket b = closed_in(each.f, each.low, each.high);
    CAPTURE(each.low, each.high, b.low, b.high);
    // To 51 of 53 bits: a few neighbours apart.
    const double few = 8 * std::numeric_limits<double>::epsilon() * each.zero;
    CHECK(b.low <= b.high);
    CHECK(b.high - b.low <= few);
    CHECK(std::fabs(b.low - each.zero) <= few);
    CHECK(
        (each.f(b.low) == 0 || each.f(b.high) == 0 || (each.f(b.low) < 0) != (each.f(b.high) < 0)));
  }
}

TEST_CASE("an end that is a zero is the zero", "[core][metrics][limit]") {
  const Bracket low = closed_in([](double x) { return x; }, 0, 1);
  CHECK(low.low == 0);
  CHECK(low.high == 0);
  const Bracket high = closed_in([](double x) { return 1 - x; }, 0, 1);
  CHECK(high.low == 1);
  CHECK(high.high == 1);
}

TEST_CASE("a minimum is found to half the digits", "[core][metrics][closed_form]") {
  const auto parabola = [](double x) { return 2 + (x - 0.3) * (x - 0.3); };
  const LeastValue least = least_between("the least value", parabola, 0, 1);
  // Nearer than the root of a rounding all values are one.
  CHECK(std::fabs(least.place - 0.3) <= 3e-8);
  CHECK(least.value == Approx(2).epsilon(1e-15));
}

TEST_CASE("what does not change its sign is not closed in on", "[core][metrics][error]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(closed_in([](double x) { return 1 + x; }, 0, 1), SearchFailure);
  CHECK_THROWS_AS(closed_in([](double x) { return 0.2 + 0.4 * x; }, 0, 1), SearchFailure);
  CHECK_THROWS_AS(closed_in([](double x) { return -0.5 - x; }, 0, 1), SearchFailure);
  const Function falling = [](double x) { return 0.5 - x; };
  CHECK_THROWS_AS(close_in(falling, {0, 1, nan, -0.5}), SearchFailure);
  CHECK_THROWS_AS(close_in(falling, {0, 1, 0.5, nan}), SearchFailure);
}

TEST_CASE("every search for a root names what it sought when there is no bracket",
          "[core][metrics][error]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const auto line = [](double x) { return x - 0.5; };
  const Bracket bad[] = {{0, 1, 1, 2},    {0, 1, nan, 1},       {0, 1, -1, nan},
                         {nan, 1, -1, 1}, {0, infinity, -1, 1}, {1, 0, 1, -1}};
  for (const Bracket& ends : bad) {
    CAPTURE(ends.low, ends.high, ends.at_low, ends.at_high);
    CHECK_THROWS_WITH(twum::closed_in("the speed", line, ends),
                      Catch::Matchers::Contains("no root found for the speed"));
  }
  const auto gap = [&](double x) { return x == 0 ? -1.0 : x == 1 ? 1.0 : nan; };
  CHECK_THROWS_AS(twum::closed_in("the speed", gap, {0, 1, -1, 1}), EvaluationError);
  // Values of any size, infinite ones too, enclose a root.
  const auto steep = [&](double x) { return x < 0.25 ? -infinity : infinity; };
  const Bracket step = twum::closed_in("the step", steep, {0, 1, -infinity, infinity});
  CHECK(std::fabs(step.low - 0.25) <= 1e-15);
  for (const double size : {1e-300, 1e300}) {
    const auto scaled = [&](double x) { return size * (x - 0.3); };
    const Bracket b = twum::closed_in("the zero", scaled, {0, 1, scaled(0), scaled(1)});
    CHECK(std::fabs(b.nearest() - 0.3) <= 1e-15);
  }
  CHECK_THROWS_AS(least_between("the least", line, nan, 1), EvaluationError);
  CHECK_THROWS_AS(least_between("the least", line, 1, 0), EvaluationError);
}

TEST_CASE(
    "two points tell the zero of a line and three that of an inverse parabola, earlier ones "
    "nothing",
    "[core][metrics][closed_form]") {
  Dice dice(71);
  for (int i = 0; i < 200; ++i) {
    const Inverse line{dice.uniform(-2, 2), dice.uniform(0.5, 2), 0, 0};
    Inverse parabola = line;
    parabola.bend = dice.uniform(-0.03, 0.03);
    InverseInterpolation straight(1, 1e-16), bent(1, 1e-16);
    // The first two of a parabola's five points are on no such curve.
    const double early[] = {dice.uniform(-9, 9), dice.uniform(1.5, 3), dice.uniform(-9, 9),
                            dice.uniform(3.5, 6)};
    bent.add(early[0], early[1]);
    bent.add(early[2], early[3]);
    for (const double f : {1.0, -0.7, 0.4}) {
      straight.add(line.x(f), f);
      bent.add(parabola.x(f), f);
      CAPTURE(i, f);
      // A dozen roundings of numbers up to 6.
      if (straight.count() > 1) CHECK(std::fabs(straight.zero() - line.zero) <= 2e-14);
    }
    CHECK(std::fabs(bent.zero() - parabola.zero) <= 2e-14);
    CHECK(straight.count() == 3);
  }
}

TEST_CASE("inverse interpolation settles soon, only at the zero, and in any unit alike",
          "[core][metrics][scaling]") {
  constexpr double kAccuracy = 1e-10;
  Dice dice(72);
  for (int i = 0; i < 300; ++i) {
    // Curves whose own scale is a thirtieth of the unit: with x - zero of that size the terms of x(f) are alike.
    const double slope = dice.log_uniform(0.1, 10), scale = 1.0 / 30;
    const Inverse curve{dice.uniform(0.5, 2), slope, dice.uniform(-1, 1) / (scale * slope * slope),
                        dice.uniform(-1, 1) / (scale * scale * slope * slope * slope)};
    const double first = curve.zero + 0.1 * scale * dice.uniform(-1, 1);
    const double second = curve.zero + 0.1 * scale * dice.uniform(-1, 1);
    std::vector<double> zeros;
    for (const double unit : {1.0, 0x1p-14, 0x1p14}) {
      InverseInterpolation line(unit, kAccuracy);
      line.add(first * unit, curve.f(first));
      line.add(second * unit, curve.f(second));
      CAPTURE(i, unit);
      CHECK_FALSE(line.has_converged());
      std::vector<double> reached{line.zero() / unit};
      // From a tenth of the scale the distances are squared, and better, in each step.
      for (int k = 0; k < 5 && !line.has_converged(); ++k) {
        const double x = reached.back();
        line.add(x * unit, curve.f(x));
        reached.push_back(line.zero() / unit);
      }
      REQUIRE(line.has_converged());
      // An inverse parabola misses a cubic x(f) by its last coefficient times the product of the three f. Once
      // settled that is within the accuracy if f is its slope times the distance, and the bend makes each f up to
      // a tenth larger.
      CHECK(std::fabs(reached.back() - curve.zero) <= 1.4 * kAccuracy);
      // Powers of two are exact.
      if (unit == 1) zeros = reached;
      CHECK(reached == zeros);
    }
  }
}

TEST_CASE("a polynomial bent to a slope keeps its points and has that slope, or is left as it was",
          "[core][metrics][closed_form]") {
  Dice dice(73);
  for (int i = 0; i < 200; ++i) {
    // A polynomial of degree three through three points and a slope is the only one.
    const double a = dice.uniform(-2, 2), b = dice.uniform(1, 2), c = dice.uniform(-0.1, 0.1);
    const auto value = [&](double x) { return a * x + b * x * x + c * x * x * x; };
    Interpolant curve;
    for (const double x : {-1.0, 0.0, 1.0}) curve.add(x, value(x));
    const double at = dice.uniform(-0.2, 0.2);
    curve.bend(at, a + 2 * b * at + 3 * c * at * at);
    const double x = dice.uniform(-1, 1);
    const Interpolant::Value p = curve.at(x);
    CAPTURE(i, at, x);
    // Some ten roundings of numbers up to 6, and the slope's by the term's, which is at least 0.8 there.
    CHECK(std::fabs(p.value - value(x)) <= 1e-14);
    CHECK(std::fabs(p.slope - (a + 2 * b * x + 3 * c * x * x)) <= 4e-14);
    CHECK(std::fabs(p.curvature - (2 * b + 6 * c * x)) <= 1e-13);
    CHECK(std::fabs(p.jerk - 6 * c) <= 1e-13);
  }
  // Where the term has no slope, it cannot be told.
  Interpolant curve;
  for (const double x : {-1.0, 0.0, 1.0}) curve.add(x, x * x);
  curve.bend(1 / std::sqrt(3.0), 7);
  CHECK(curve.at(0.5).value == 0.25);
}

TEST_CASE("two points tell the zero of what is known well, and of nothing else",
          "[core][metrics][closed_form]") {
  constexpr double kAccuracy = 1e-13;
  Dice dice(74);
  int told = 0;
  for (int i = 0; i < 300; ++i) {
    const double zero = dice.uniform(0.3, 0.7), slope = -dice.log_uniform(0.1, 10);
    const double bend = slope * dice.uniform(-20, 20);
    const auto f = [&](double x) { return (x - zero) * (slope + 0.5 * bend * (x - zero)); };
    const double first = zero + dice.log_uniform(1e-6, 1e-4);
    const double second = zero + dice.log_uniform(1e-10, 1e-7);
    const auto found = [&](double known_slope, double known_bend) {
      InverseInterpolation line(1, kAccuracy);
      line.add(first, f(first));
      line.add(second, f(second));
      return line.zero_of_two(known_slope, known_bend);
    };
    const double here = slope + bend * (second - zero);
    CAPTURE(i, zero, first, second);
    // A curvature that is wrong by ten times the share by which it moves the slope, as is allowed for.
    const double moved = 0.5 * bend * (second - first) / slope;
    if (const auto at = found(here, bend * (1 + 10 * moved * dice.uniform(-1, 1)))) {
      ++told;
      CHECK(std::fabs(*at - zero) <= 1.1 * kAccuracy);  // and terms of the next order
    }
    // A slope that disagrees with the secant by a tenth moves steps of 1e-10 and more by more than 1e-13.
    CHECK_FALSE(found(1.1 * here, bend));
    CHECK_FALSE(found(1.1 * here, 0));
  }
  CHECK(told > 150);
}
