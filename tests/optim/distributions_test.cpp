// SPDX-License-Identifier: Apache-2.0
#include <twum/optim/distributions.hpp>
#include <twum/optim/problem.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <numbers>

using namespace twum::optim;
using Catch::Matchers::WithinRel;

namespace {

// What the distributions promise, and about as many roundings of the closed forms.
constexpr double kExact = 3e-14;

}  // namespace

TEST_CASE("Student's t has the closed forms of one and of two degrees of freedom",
          "[optim][statistics][closed_form]") {
  for (const double p : {0.6, 0.9, 0.975, 0.9995}) {
    CAPTURE(p);
    const double of_one = std::tan(std::numbers::pi * (p - 0.5));
    const double of_two = (2 * p - 1) / std::sqrt(2 * p * (1 - p));
    CHECK_THAT(student_quantile(1, p), WithinRel(of_one, 3e-13));  // the tangent near a pole
    CHECK_THAT(student_quantile(2, p), WithinRel(of_two, kExact));
    CHECK_THAT(student_tails(1, of_one), WithinRel(2 * (1 - p), 3e-13));
    CHECK_THAT(student_tails(2, of_two), WithinRel(2 * (1 - p), 3e-13));
  }
  CHECK(student_tails(3, 0) == 1);
}

TEST_CASE("Student's t of ever more degrees of freedom is a normal number",
          "[optim][statistics][limit]") {
  // The quantile moves by z (z^2 + 1) / (4 freedom), and the next term is 2.8 / freedom^2.
  const double z = normal_quantile(0.975), freedom = 1e6;
  CHECK(student_quantile(kInfinity, 0.975) == z);
  const double moved = z * (z * z + 1) / (4 * freedom);
  CHECK(std::fabs(student_quantile(freedom, 0.975) - z - moved) <= 10 / (freedom * freedom));
  CHECK_THAT(student_tails(kInfinity, z), WithinRel(0.05, kExact));
  CHECK(normal_quantile(0) == -kInfinity);
  CHECK(normal_quantile(1) == kInfinity);
}

TEST_CASE("chi-square with two degrees of freedom is exponential, and so is F's odds",
          "[optim][statistics][closed_form]") {
  for (const double p : {0.1, 0.5, 0.95, 0.999}) {
    CAPTURE(p);
    const double x = -2 * std::log1p(-p);
    CHECK_THAT(chi_square_quantile(2, p), WithinRel(x, kExact));
    CHECK_THAT(chi_square_tail(2, x), WithinRel(1 - p, 3e-13));
    // The quotient of two exponential numbers.
    CHECK_THAT(fisher_quantile(2, 2, p), WithinRel(p / (1 - p), 1e-12));
  }
  CHECK_THAT(chi_square_tail(1, 1.7 * 1.7),
             WithinRel(std::erfc(1.7 / std::numbers::sqrt2), kExact));
  CHECK(chi_square_tail(0, 1) == 1);
}

TEST_CASE("counts of hits add up, and the quantile is the first count that reaches its level",
          "[optim][statistics][identity]") {
  constexpr int kDraws = 12;
  for (const double p : {0.03, 0.4, 0.75}) {
    double sum = 0, term = std::pow(1 - p, kDraws);
    for (int k = 0; k < kDraws; ++k) {
      const double before = sum;
      sum += term;
      term *= p / (1 - p) * (kDraws - k) / (k + 1);
      CAPTURE(p, k);
      CHECK_THAT(binomial_cdf(kDraws, p, k), WithinRel(sum, kExact));
      if (sum - before > 1e-9) CHECK(binomial_quantile(kDraws, p, 0.5 * (before + sum)) == k);
    }
  }
}

TEST_CASE("the ends of Clopper and Pearson leave their tails", "[optim][statistics][identity]") {
  constexpr double kTail = 0.025;
  const ProbabilityRange range = probability_range(7, 40, kTail);
  CHECK_THAT(1 - binomial_cdf(40, range.low, 6), WithinRel(kTail, 1e-12));
  CHECK_THAT(binomial_cdf(40, range.high, 7), WithinRel(kTail, 1e-12));
  CHECK(probability_range(0, 40, kTail).low == 0);
  CHECK(probability_range(40, 40, kTail).high == 1);
  CHECK_THAT(probability_range(0, 40, kTail).high, WithinRel(1 - std::pow(kTail, 1.0 / 40), 1e-12));
}

TEST_CASE("a distribution never throws: zeros, infinities and NaN give a limit or NaN",
          "[optim][statistics][edge]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double ends[] = {0.0,   -0.0,      1.0,        -1.0, 0.5,  2.0,   1e-320,
                         1e300, kInfinity, -kInfinity, nan,  12.0, 1e-300};
  for (const double a : ends)
    for (const double b : ends) {
      CAPTURE(a, b);
      CHECK_NOTHROW(student_quantile(a, b));
      CHECK_NOTHROW(student_tails(a, b));
      CHECK_NOTHROW(chi_square_quantile(a, b));
      CHECK_NOTHROW(chi_square_tail(a, b));
      // A probability has no meaning with a NaN, and lies between 0 and 1 otherwise.
      const bool undefined = std::isnan(a) || std::isnan(b);
      const double tail = chi_square_tail(a, b), tails = student_tails(a, b);
      CHECK((std::isnan(tail) || (tail >= 0 && tail <= 1)));
      CHECK((std::isnan(tails) || (tails >= 0 && tails <= 1)));
      if (undefined) CHECK((std::isnan(tail) && std::isnan(tails)));
      for (const double c : ends) {
        CAPTURE(c);
        CHECK_NOTHROW(fisher_quantile(a, b, c));
        CHECK_NOTHROW(binomial_cdf(a, b, c));
        CHECK_NOTHROW(binomial_quantile(a, b, c));
        CHECK_NOTHROW(normal_cdf(a, b, c));
        const double share = binomial_cdf(a, b, c);
        CHECK((std::isnan(share) || (share >= 0 && share <= 1)));
      }
    }
  CHECK(std::isnan(normal_quantile(nan)));
  CHECK(student_tails(3, kInfinity) == 0);
  CHECK(chi_square_tail(3, kInfinity) == 0);
  CHECK(student_quantile(3, 0) == -kInfinity);
  CHECK(student_quantile(3, 1) == kInfinity);
  CHECK(chi_square_quantile(3, 0) == 0);
  CHECK(binomial_cdf(10, 0.3, 10) == 1);
}
