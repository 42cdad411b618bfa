// SPDX-License-Identifier: Apache-2.0
#include "random_contact.hpp"
#include "two_dips.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace twum;
using namespace twum::contact;
using namespace twum::test;

namespace {

// The first place where the curve is not positive, on a fine grid: an oracle that knows no bounds.
template <typename Curve>
double first_on_grid(const Curve& curve, double length, int steps) {
  for (int k = 1; k <= steps; ++k) {
    if (curve.sample(length * k / steps).f <= 0) return length * k / steps;
  }
  return kNoZero;
}

}  // namespace

TEST_CASE("steps (E3.1, E3.2, E3.7) stay where the curve is positive", "[core][events][identity]") {
  Dice dice(21);
  int rising = 0;
  for (int i = 0; i < 1000; ++i) {
    const RandomSlip slip(random_contact(dice, i), dice);
    const SlipCurve curve = slip.curve();
    const double x = dice.uniform(0, 0.9) * slip.length;
    const CurveSample c = curve.sample(x);
    if (!(c.f > 1e-9)) continue;
    const double step = zero_free_step(c, StartOrder::positive);
    CHECK(step >= quadratic_step(c));
    rising += c.f1 > 0 && step > quadratic_step(c);
    // The bounds hold with rounding of about 1e-15 of the curve's largest terms.
    for (int k = 0; k <= 100; ++k) REQUIRE(curve.sample(x + step * k / 100).f > -1e-14);
  }
  CHECK(rising > 50);
}

TEST_CASE("steps of cubics that are their own bound end at their zero (E3.3, E3.7)",
          "[core][events][closed_form]") {
  Dice dice(24);
  for (int i = 0; i < 1000; ++i) {
    // f = f_0 + f_1 t + f_2 t^2 / 2 - l t^3 / 6 with the third derivative -l all along
    const double f1 = dice.log_uniform(1e-6, 1), f2 = dice.uniform(-1, 1),
                 l = dice.log_uniform(1e-2, 10);
    const auto cubic = [&](double f0, double t) {
      return f0 + t * (f1 + t * (f2 / 2 - t * l / 6));
    };
    const double huge = 1e6;  // a bound of f'' that says nothing
    const double left = zero_free_step({0, f1, f2, huge, l, 0, -l}, StartOrder::zero);
    CHECK(cubic(0, left) > 0);
    CHECK(cubic(0, left / 0.95 * (1 + 1e-9)) < 0);
    const double f0 = dice.log_uniform(1e-6, 1);
    const double step = zero_free_step({f0, f1, f2, huge, l, 0, -l}, StartOrder::positive);
    const double top = (f2 + std::sqrt(f2 * f2 + 2 * l * f1)) / l;
    CHECK(cubic(f0, step) > 0);
    CHECK(step > top);
    // At twice y = 1 / sqrt(1 + c) the cubic is below zero as long as 4 + 8 c y > 1 + c, which c < 60 meets.
    const double bend = l * top - f2, c = l * std::sqrt(2 * cubic(f0, top) / bend) / (3 * bend);
    if (c < 60) CHECK(cubic(f0, top + 2 * (step - top)) < 0);
  }
}

TEST_CASE("falling steps (E3.2) of a cubic that is its own bound close in on its zero",
          "[core][events][closed_form]") {
  Dice dice(25);
  for (int i = 0; i < 1000; ++i) {
    const double f0 = dice.log_uniform(1e-3, 1), f1 = -dice.log_uniform(1e-3, 1),
                 f2 = -dice.log_uniform(1e-3, 1), l = dice.log_uniform(1e-2, 10);
    const auto cubic = [&](double t) { return f0 + t * (f1 + t * (f2 / 2 - t * l / 6)); };
    double low = 0, high = 1;
    while (cubic(high) > 0) high *= 2;
    for (int k = 0; k < 60; ++k) (cubic(0.5 * (low + high)) > 0 ? low : high) = 0.5 * (low + high);
    const CurveSample c{f0, f1, f2, HUGE_VAL, l, 0, -l};
    // Newton's step and the chord to it leave of the distance d to the zero at most d^2 |q''| / (2 |q'|) twice
    // over: from halfway, where d |q''| < 2 |q'| for a concave cubic, three steps are below a thousandth.
    double t = 0.5 * low;
    for (int k = 0; k < 3; ++k) {
      const double next = falling_step(c, t);
      CHECK(next >= t);
      CHECK(next <= low * (1 + 1e-14));
      t = next;
    }
    CHECK(low - t < 1e-3 * low);
  }
}

TEST_CASE("steps after an event (E3.3, E3.4) stay where the curve is positive",
          "[core][events][identity]") {
  const TwoDips rising{0, 1.5, 0};  // f = f' = 0 at 0
  const double step = zero_free_step(rising.first(), StartOrder::double_zero);
  CHECK(step > 0);
  for (int k = 1; k <= 100; ++k) CHECK(rising.sample(step * k / 100).f > 0);
  const CurveSample simple{0, 1, -3, 3, 0, 0, 0};  // f = t - 1.5 t^2
  CHECK(std::fabs(zero_free_step(simple, StartOrder::zero) - 0.95 / 1.5) < 1e-15);
}

TEST_CASE("a bracket (E3.5) holds exactly one zero", "[core][events][identity]") {
  Dice dice(22);
  int brackets = 0;
  for (int i = 0; i < 3000; ++i) {
    const RandomSlip slip(random_contact(dice, i), dice);
    const SlipCurve curve = slip.curve();
    const double x = dice.uniform(0, 1) * slip.length;
    const CurveSample c = curve.sample(x);
    const double reach = c.f > 0 ? zero_bracket(c) : 0;
    if (!(reach > 0)) continue;
    ++brackets;
    int changes = 0;
    double last = c.f;
    for (int k = 1; k <= 200; ++k) {
      const double f = curve.sample(x + reach * k / 200).f;
      changes += (f > 0) != (last > 0);
      last = f;
    }
    REQUIRE(changes == 1);
  }
  CHECK(brackets > 100);
}

TEST_CASE("the march finds the zero that a fine grid finds, never a later one",
          "[core][events][differential]") {
  Dice dice(23);
  int zeros = 0;
  for (int i = 0; i < 2000; ++i) {
    const RandomSlip slip(random_contact(dice, i), dice);
    const SlipCurve curve = slip.curve();
    if (!(curve.first().f > 1e-6)) continue;
    long work = 0;
    const double zero = first_zero(curve, slip.length, StartOrder::positive, work, 1'000'000);
    const double seen = first_on_grid(curve, slip.length, 20000);
    // The grid may miss a dip that the march finds, never the other way round.
    REQUIRE(zero <= seen);
    if (zero == kNoZero) continue;
    ++zeros;
    const CurveSample c = curve.sample(zero);
    // A root is good to a few units of rounding over the slope.
    CHECK(std::fabs(c.f) <= 1e-13 * (1 + std::fabs(c.f1)));
  }
  CHECK(zeros > 500);
}

TEST_CASE("a known zero (E3.6) ends the march where it is the first, and only there",
          "[core][events][differential]") {
  Dice dice(24);
  int first = 0, later = 0;
  long with_first = 0, without_first = 0;
  for (int i = 0; i < 4000; ++i) {
    const RandomSlip slip(random_contact(dice, i), dice);
    const SlipCurve curve = slip.curve();
    if (!(curve.first().f > 1e-6)) continue;
    long without = 0;
    const double zero = first_zero(curve, slip.length, StartOrder::positive, without, 1'000'000);
    if (zero == kNoZero) continue;
    // Every falling zero, told as if it were the first.
    double last = curve.first().f;
    for (int k = 1; k <= 500; ++k) {
      const double x = slip.length * k / 500, f = curve.sample(x).f;
      const bool falls = last > 0 && f <= 0;
      last = f;
      if (!falls) continue;
      const double told = polish_zero(curve, x - slip.length / 500, x, x, curve.sample(x));
      const KnownZero known = known_zero(curve, told * (1 + 1e-9), slip.length);
      long with = 0;
      const double found =
          first_zero(curve, slip.length, StartOrder::positive, with, 1'000'000, known);
      const double slope = std::fabs(curve.sample(zero).f1);
      // Both are good to rounding over the slope, as above.
      REQUIRE(std::fabs(found - zero) * slope <= 2e-13 * (1 + slope));
      if (known.zero == kNoZero) continue;
      if (std::fabs(told - zero) * slope > 2e-13 * (1 + slope)) {
        ++later;
        continue;
      }
      ++first;
      // The march takes the same steps until it is told that it has arrived.
      CHECK(with <= without);
      with_first += with;
      without_first += without;
    }
  }
  CHECK(first > 1000);
  CHECK(later > 100);
  // What it is told for: marches take three samples on average, and most are spared the last, beside the zero.
  CHECK(5 * with_first <= 4 * without_first);
}

TEST_CASE("what is no zero nearby is not known", "[core][events][range]") {
  const TwoDips curve{0.5, 1.3, -1e-3};
  CHECK(known_zero(curve, kNoZero, 2).zero == kNoZero);
  CHECK(known_zero(curve, 0.1, 2).zero == kNoZero);  // a step from here is no last one
  CHECK(known_zero(curve, 0.9, 2).zero == kNoZero);  // f rises
  CHECK(std::isnan(followed_zero(TwoDips{0.5, 1.3, 1}, 0.4, 2)));
}

TEST_CASE("dips are told from zeros however shallow", "[core][events][closed_form]") {
  for (const double depth : {1e-3, 1e-6, 1e-9, 1e-12}) {
    long work = 0;
    CHECK(first_zero(TwoDips{0.5, 1.3, depth}, 2, StartOrder::positive, work, 1'000'000) ==
          kNoZero);
    const double zero =
        first_zero(TwoDips{0.5, 1.3, -depth}, 2, StartOrder::positive, work, 1'000'000);
    // Near 0.5 f = 0.64 (x - 0.5)^2 - depth (1 + ...): the first zero lies sqrt(depth) / 0.8 before it, with
    // a correction of the order of depth.
    CHECK(std::fabs(zero - (0.5 - std::sqrt(depth) / 0.8)) <= 2 * depth + 1e-9);
  }
}

TEST_CASE("the march gives up with a word, not with a wrong zero", "[core][events][range]") {
  long work = 0;
  CHECK(std::isnan(first_zero(TwoDips{0.5, 1.3, 1e-12}, 2, StartOrder::positive, work, 3)));
}
