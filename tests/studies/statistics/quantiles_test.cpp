// SPDX-License-Identifier: Apache-2.0
#include "studies/statistics/coverage.hpp"

#include <catch2/catch.hpp>

#include <twum/optim/random.hpp>
#include <twum/studies/estimate.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace {

using namespace twum::studies;
using twum::test::Coverage;

std::vector<double> one_to(int n) {
  std::vector<double> numbers(static_cast<std::size_t>(n));
  std::iota(numbers.begin(), numbers.end(), 1.0);
  return numbers;
}

// P(at least k of n) term by term.
double at_least(int k, int n, double p) {
  double sum = 0;
  for (int i = k; i <= n; ++i) {
    sum += std::exp(std::lgamma(n + 1.0) - std::lgamma(i + 1.0) - std::lgamma(n - i + 1.0) +
                    i * std::log(p) + (n - i) * std::log1p(-p));
  }
  return sum;
}

}  // namespace

TEST_CASE("the interval of a median lies between the order statistics of the tables",
          "[studies][quantiles]") {
  // Order statistics of 95 % intervals of a median, as in any table of the sign test.
  CHECK(quantile_estimate(one_to(10), 0.5, 0.95).low == 2);
  CHECK(quantile_estimate(one_to(10), 0.5, 0.95).high == 9);
  CHECK(quantile_estimate(one_to(20), 0.5, 0.95).low == 6);
  CHECK(quantile_estimate(one_to(20), 0.5, 0.95).high == 15);
  // Of five draws not even the extremes enclose a median with 95 %: 1 - 2 / 32.
  CHECK(std::isnan(quantile_estimate(one_to(5), 0.5, 0.95).low));
  CHECK(std::isnan(quantile_estimate(one_to(5), 0.5, 0.95).high));
  CHECK(quantile_estimate(one_to(6), 0.5, 0.95).low == 1);
  // 0.95^58 = 5.1 %, 0.95^59 = 4.8 %: the sample size behind the 95/95 rule, one-sided.
  CHECK(std::isnan(quantile_estimate(one_to(58), 0.95, 0.9).high));
  CHECK(quantile_estimate(one_to(59), 0.95, 0.9).high == 59);
}

TEST_CASE("quantiles lie between the nearest order statistics", "[studies][quantiles]") {
  CHECK(quantile_estimate(one_to(5), 0.5, 0.95).value == 3);
  CHECK(quantile_estimate(one_to(4), 0.5, 0.95).value == 2.5);
  CHECK(quantile_estimate(one_to(11), 0.05, 0.95).value == Approx(1.5).epsilon(1e-15));
  CHECK(quantile_estimate(one_to(1), 0.9, 0.95).value == 1);
  CHECK(std::isnan(quantile_estimate({}, 0.5, 0.95).value));
}

TEST_CASE("intervals of quantiles cover at least as often as they say", "[studies][quantiles]") {
  for (const double p : {0.05, 0.5, 0.99}) {
    Coverage coverage;
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
      twum::optim::Random random(seed, 0, 0);
      std::vector<double> draws(400);
      for (double& d : draws) d = random.uniform();
      std::sort(draws.begin(), draws.end());
      Estimate e = quantile_estimate(draws, p, 0.95);
      if (std::isnan(e.high)) e.high = 1;
      coverage.count(e, p);
    }
    INFO(p << ": " << coverage.share());
    CHECK(coverage.hits >= coverage.fewest(0.95));
    CHECK(coverage.hits <= coverage.most(0.98));  // one step of the order statistics is 2 % or less
  }
}

TEST_CASE("the interval of a proportion has the tails that define it", "[studies][quantiles]") {
  for (const auto& [k, n] : {std::pair{1, 10}, std::pair{7, 10}, std::pair{950, 1000}}) {
    const Estimate e =
        proportion_estimate(static_cast<unsigned>(k), static_cast<unsigned>(n), 0.95);
    CHECK(e.value == Approx(static_cast<double>(k) / n).epsilon(1e-15));
    // lgamma of 1000 is 6000, its rounding 1e-12 of the probability.
    CHECK(at_least(k, n, e.low) == Approx(0.025).epsilon(1e-10));
    CHECK(1 - at_least(k + 1, n, e.high) == Approx(0.025).epsilon(1e-9));
  }
  // None of n: (1 - p)^n = 0.025.
  const Estimate none = proportion_estimate(0, 50, 0.95);
  CHECK(none.low == 0);
  CHECK(none.high == Approx(1 - std::pow(0.025, 1.0 / 50)).epsilon(1e-12));
  const Estimate all = proportion_estimate(50, 50, 0.95);
  CHECK(all.high == 1);
  CHECK(all.low == Approx(std::pow(0.025, 1.0 / 50)).epsilon(1e-12));
  CHECK(std::isnan(proportion_estimate(0, 0, 0.95).value));
}

TEST_CASE("quantiles of times of which some have no end are times or have no end",
          "[statistics][edge_case]") {
  const double never = std::numeric_limits<double>::infinity();
  const std::vector<double> times{1, 2, 3, never, never};
  CHECK(quantile_estimate(times, 0.25, 0.95).value == 2);
  CHECK(quantile_estimate(times, 0.5, 0.95).value == 3);
  CHECK(quantile_estimate(times, 0.9, 0.95).value == never);  // between two that have none
  CHECK(quantile_estimate(times, 0.6, 0.95).value == never);
}
