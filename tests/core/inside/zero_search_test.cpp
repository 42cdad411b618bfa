// SPDX-License-Identifier: Apache-2.0
#include "random_contact.hpp"
#include "two_dips.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace twum;
using namespace twum::contact;
using namespace twum::test;

namespace {

// A sample in other units: f times 2^k, x divided by 2^m. Powers of two are exact.
CurveSample in_units(const CurveSample& c, int k, int m) {
  const double f = std::ldexp(1, k), x = std::ldexp(1, m);
  return {c.f * f,    c.f1 * f * x,        c.f2 * f * x * x, c.l2 * f * x * x, c.l3 * f * x * x * x,
          c.skip / x, c.f3 * f * x * x * x};
}

template <typename Curve>
struct InUnits {
  const Curve& curve;
  int k, m;
  CurveSample first() const { return in_units(curve.first(), k, m); }
  CurveSample sample(double x) const { return in_units(curve.sample(std::ldexp(x, m)), k, m); }
  CurveSample terms(double x) const { return in_units(curve.terms(std::ldexp(x, m)), k, m); }
};

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

// How often each of the searches had something to search.
struct Searched {
  int steps{0}, marches{0}, zeros{0};
};

// Every search of the curve in the units told, against that in its own: to the bit.
template <typename Curve>
void check_units(const Curve& curve, double length, double x, int k, int m, Searched& searched) {
  const InUnits<Curve> other{curve, k, m};
  const double unit = std::ldexp(1, -m);
  CAPTURE(k, m, length, x);
  const CurveSample c = curve.sample(x), o = other.sample(x * unit);
  if (c.f > 0) {
    ++searched.steps;
    CHECK(same(zero_free_step(o, StartOrder::positive),
               zero_free_step(c, StartOrder::positive) * unit));
    CHECK(same(falling_step(o, quadratic_step(o)), falling_step(c, quadratic_step(c)) * unit));
    CHECK(same(zero_bracket(o), zero_bracket(c) * unit));
  }
  CHECK(same(householder_step(o), householder_step(c) * unit));
  for (const double share : {1.0, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6})
    CHECK(is_last_step(o, o.l3, share * unit) == is_last_step(c, c.l3, share));
  CHECK(
      same(followed_zero(other, x * unit, length * unit), followed_zero(curve, x, length) * unit));
  if (!(curve.first().f > 0)) return;
  ++searched.marches;
  long work = 0, other_work = 0;
  const double zero = first_zero(curve, length, StartOrder::positive, work, 100'000);
  CHECK(same(first_zero(other, length * unit, StartOrder::positive, other_work, 100'000),
             zero * unit));
  CHECK(other_work == work);
  if (zero == kNoZero) return;
  ++searched.zeros;
  const KnownZero known = known_zero(curve, zero + 1e-4 * length, length);
  const KnownZero told = known_zero(other, (zero + 1e-4 * length) * unit, length * unit);
  REQUIRE(same(told.zero, known.zero * unit));
  work = other_work = 0;
  const double again = first_zero(curve, length, StartOrder::positive, work, 100'000, known);
  CHECK(same(first_zero(other, length * unit, StartOrder::positive, other_work, 100'000, told),
             again * unit));
  CHECK(other_work == work);
}

}  // namespace

TEST_CASE("the searches for zeros (E3.1 to E3.7) are the same in any unit",
          "[core][events][scaling]") {
  Dice dice(71);
  Searched searched;
  for (int i = 0; i < 400; ++i) {
    const RandomSlip slip(random_contact(dice, i), dice);
    const double x = dice.uniform(0, 1) * slip.length;
    for (const int k : {-20, 0, 20})
      for (const int m : {-20, 0, 20}) check_units(slip.curve(), slip.length, x, k, m, searched);
  }
  for (const double floor : {-1e-1, -1e-3, -1e-6, 1e-3})
    for (const double x : {0.1, 0.4, 0.45, 0.6, 1.2, 1.7})
      for (const int k : {-20, 0, 20})
        for (const int m : {-20, 0, 20})
          check_units(TwoDips{0.5, 1.3, floor}, 2, x, k, m, searched);
  // In nine units each: a hundred random curves at least have something for every search.
  CHECK(searched.steps > 900);
  CHECK(searched.marches > 900);
  CHECK(searched.zeros > 900);
}

TEST_CASE(
    "Householder's step (E3.8) has the error of fourth order that the expansion of 1 / f tells",
    "[core][events][closed_form]") {
  Dice dice(72);
  const double r = 0.01;
  for (int i = 0; i < 1000; ++i) {
    // f = (r - t) (1 + a t + b t^2)
    const double a = dice.uniform(0.5, 1) * (i % 2 == 0 ? 1 : -1),
                 b = dice.uniform(0.5, 1) * (i % 4 < 2 ? 1 : -1);
    const CurveSample cubic{r, a * r - 1, 2 * (b * r - a), HUGE_VAL, HUGE_VAL, 0, -6 * b};
    // The step is 3 (1 / f)'' / (1 / f)'''. With 1 / f = A / (r - t) + g it is r (1 + r^3 g'' / (2 A) + ...), where
    // g'' is minus a third of the third derivative of 1 / (1 + a t + b t^2), -6 (a^3 - 2 a b). The next terms, and
    // a and b at t = r instead of 0, make a difference of some 25 r^4.
    const double expected = (a * a * a - 2 * a * b) * r * r * r;
    CHECK(std::fabs(householder_step(cubic) / r - 1 - expected) <= 3e-7);
  }
}

TEST_CASE("where f bends too strongly for Householder's step Newton's is taken",
          "[core][events][closed_form]") {
  // f' = -1: the step is f (1 - f f'' / 2) / (1 - f f'' - f^2 f''' / 6). It is taken where the denominator differs
  // from the numerator by less than half of that: f f'' < 2 / 3 and > -2 without f''', |f^2 f'''| < 3 without f''.
  const auto step = [](double f, double f2, double f3) {
    return householder_step(CurveSample{f, -1, f2, 0, 0, 0, f3});
  };
  CHECK(step(0.66, 1, 0) > 0.66);
  CHECK(step(0.67, 1, 0) == 0.67);
  CHECK(step(1.99, -1, 0) < 1.99);
  CHECK(step(2.01, -1, 0) == 2.01);
  CHECK(step(1, 0, 2.9) > 1);
  CHECK(step(1, 0, 3.1) == 1);
  CHECK(step(1, 0, -2.9) < 1);
  CHECK(step(1, 0, -3.1) == 1);
}

TEST_CASE("polished zeros are those of their bracket, wherever the first step leads",
          "[core][events][closed_form]") {
  // f = cos x - 0.5 from where it is so flat that a step leaves the bracket.
  const StickCurve cosine({0.5, 0, -1, 0}, 0, trig(0.0));
  const double turn = 2 * std::numbers::pi, flat = turn + 0.01;
  const double zero = polish_zero(cosine, flat, turn + 3, flat, cosine.sample(flat));
  // Places of 7.3 are rounded by 9e-16, the phase's as well, and f over its slope of 0.87 by 4e-16.
  CHECK(std::fabs(zero - (turn + std::numbers::pi / 3)) <= 3e-15);
}

TEST_CASE("a stick zone that begins with f = 0 does not end there, whatever place is told (E2.4)",
          "[core][events][closed_form]") {
  // f = sin x - x / 2 rises from zero, and there is another zero at the start for a step to lead to.
  const StickCurve curve({0, -0.5, 0, 1}, 0, trig(0.0));
  REQUIRE(curve.glance(3, StartOrder::zero, trig(3.0)) == StickCurve::Glance::one_zero);
  // The zero by halving in long double.
  long double low = 1, high = 3;
  for (int k = 0; k < 80; ++k) {
    const long double middle = (low + high) / 2;
    (std::sin(middle) > middle / 2 ? low : high) = middle;
  }
  for (const double near : {1e-12, 1e-9, 1e-7, 1e-5, 1e-3, 0.5, 1.0, 1.9, 2.9, kNoZero}) {
    CAPTURE(near);
    // f is a difference of numbers of 0.95, with 1.1e-16 of rounding each, over its slope of 0.82.
    CHECK(std::fabs(curve.only_zero(3, near) - static_cast<double>(low)) <= 1e-15);
  }
}

TEST_CASE("zeros beyond the zone and rising ones are not known", "[core][events][closed_form]") {
  const TwoDips curve{0.5, 1.3, -1e-3};
  const double falling = curve.falling_zero(), rising = curve.rising_zero();
  REQUIRE(curve.sample(falling).f1 < 0);
  REQUIRE(curve.sample(rising).f1 > 0);
  // f is rounded by 1e-17 here, over a slope of 0.055, and the closed form by 2e-16.
  CHECK(std::fabs(known_zero(curve, falling - 1e-6, 2).zero - falling) <= 1e-15);
  CHECK(known_zero(curve, falling - 1e-6, falling - 5e-7).zero == kNoZero);
  CHECK(known_zero(curve, rising - 1e-6, 2).zero == kNoZero);
  CHECK(known_zero(curve, 0.7, 2).zero == kNoZero);  // f rises here too
  // A zero just before the start.
  const TwoDips shifted{0.5 - falling - 1e-7, 1.3 - falling - 1e-7, -1e-3};
  CHECK(known_zero(shifted, 1e-9, 2).zero == kNoZero);
}

TEST_CASE("few steps follow a zero to where it has moved (E6.5)", "[core][events][closed_form]") {
  const TwoDips curve{0.5, 1.3, -1e-3};
  const double zero = curve.falling_zero();
  for (const double x : {0.44, 0.445, 0.45, 0.455, 0.46, 0.462, 0.464, 0.47, 0.48}) {
    CAPTURE(x);
    // The last step is at most a thousandth of slope over curvature, 0.0557 / 1.68, and leaves a^3 - 2 a b + c = 2500
    // times its fourth power, 3e-15, where 1, a, b, c are the Taylor coefficients of f over its slope.
    CHECK(std::fabs(followed_zero(curve, x, 2) - zero) <= 5e-15);
  }
  // In other units: there the zero lies at 59.
  const InUnits<TwoDips> wide{curve, 0, -7};
  CHECK(std::fabs(followed_zero(wide, 0.45 * 128, 256) - zero * 128) <= 128 * 5e-15);
}
