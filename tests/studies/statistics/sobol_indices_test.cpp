// SPDX-License-Identifier: Apache-2.0
#include "studies/statistics/coverage.hpp"

#include <catch2/catch.hpp>

#include <twum/optim/random.hpp>
#include <twum/studies/sobol_indices.hpp>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

namespace {

using namespace twum::studies;
using twum::test::Coverage;

constexpr double kPi = std::numbers::pi;

struct Function {
  std::function<double(std::span<const double>)> value;
  std::vector<double> first;
  std::vector<double> total;
};

double ishigami(std::span<const double> u) {
  const auto x = [&](std::size_t j) { return kPi * (2 * u[j] - 1); };
  const double s = std::sin(x(1));
  return std::sin(x(0)) + 7 * s * s + 0.1 * std::pow(x(2), 4) * std::sin(x(0));
}

// Ishigami and Homma 1990, a = 7, b = 0.1.
Function ishigami_function() {
  return {ishigami, {0.3139051911, 0.4424111448, 0}, {0.5575888552, 0.4424111448, 0.2436836641}};
}

// Sobol's g: variances of its factors are 1 / (3 (1 + a)^2), and all the rest follows (Saltelli and
// Sobol 1995).
Function g_function() {
  const std::vector<double> a{0, 1, 4.5, 9, 99, 99, 99, 99};
  Function function;
  function.value = [a](std::span<const double> u) {
    double product = 1;
    for (std::size_t j = 0; j < a.size(); ++j)
      product *= (std::abs(4 * u[j] - 2) + a[j]) / (1 + a[j]);
    return product;
  };
  double all = 1;
  for (const double aj : a) all *= 1 + 1 / (3 * (1 + aj) * (1 + aj));
  for (const double aj : a) {
    const double v = 1 / (3 * (1 + aj) * (1 + aj));
    function.first.push_back(v / (all - 1));
    function.total.push_back(v * all / (1 + v) / (all - 1));
  }
  return function;
}

// A sum of terms c u: shares c^2 over their sum, without interactions.
Function sum_function() {
  const std::vector<double> c{1, 0.5, 0.1, 0.01};
  Function function;
  function.value = [c](std::span<const double> u) {
    double sum = 0;
    for (std::size_t j = 0; j < c.size(); ++j) sum += c[j] * u[j];
    return sum;
  };
  double all = 0;
  for (const double one : c) all += one * one;
  for (const double one : c) function.first.push_back(one * one / all);
  function.total = function.first;
  return function;
}

// A product of factors 1 + c u, whose squared variation is v = c^2 / 12 / (1 + c / 2)^2: shares v over the product of 1 + v, less 1.
Function product_function() {
  const std::vector<double> c{3, 1, 0.3};
  Function function;
  function.value = [c](std::span<const double> u) {
    double product = 1;
    for (std::size_t j = 0; j < c.size(); ++j) product *= 1 + c[j] * u[j];
    return product;
  };
  double all = 1;
  std::vector<double> v;
  for (const double one : c) {
    v.push_back(one * one / 12 / ((1 + one / 2) * (1 + one / 2)));
    all *= 1 + v.back();
  }
  for (const double one : v) {
    function.first.push_back(one / (all - 1));
    function.total.push_back(one * all / (1 + one) / (all - 1));
  }
  return function;
}

SobolIndices measured(const Function& function, std::uint64_t blocks, std::uint64_t seed) {
  const std::size_t d = function.first.size();
  const SobolDesign design(d, seed);
  SobolIndices indices(d);
  std::vector<double> u(d);
  std::vector<double> values(design.block_size());
  for (std::uint64_t block = 0; block < blocks; ++block) {
    for (std::size_t m = 0; m < values.size(); ++m) {
      design.point(block, m, u);
      values[m] = function.value(u);
    }
    indices.add(block, values);
  }
  return indices;
}

void check_within(const Function& function, std::uint64_t blocks, double half_width) {
  // A million to one for each interval that a right estimator passes.
  const auto shares = measured(function, blocks, 1).shares(0.999999);
  const auto narrow = measured(function, blocks, 1).shares(0.95);
  for (std::size_t j = 0; j < shares.size(); ++j) {
    INFO("variable " << j);
    CHECK(shares[j].first.low <= function.first[j]);
    CHECK(shares[j].first.high >= function.first[j]);
    CHECK(shares[j].total.low <= function.total[j]);
    CHECK(shares[j].total.high >= function.total[j]);
    CHECK(narrow[j].first.high - narrow[j].first.low < 2 * half_width);
    CHECK(narrow[j].total.high - narrow[j].total.low < 2 * half_width);
  }
}

// Coverage of each index by itself: within a seed they depend on each other.
void check_coverage(const Function& function, std::uint64_t blocks, int seeds, double least,
                    double most) {
  const std::size_t d = function.first.size();
  std::vector<Coverage> first(d);
  std::vector<Coverage> total(d);
  for (int seed = 0; seed < seeds; ++seed) {
    const auto shares =
        measured(function, blocks, 1000U + static_cast<unsigned>(seed)).shares(0.95);
    for (std::size_t j = 0; j < d; ++j) {
      first[j].count(shares[j].first, function.first[j], 1e-12);
      total[j].count(shares[j].total, function.total[j], 1e-9);  // published to ten digits
    }
  }
  for (std::size_t j = 0; j < d; ++j) {
    INFO("variable " << j << ": " << first[j].share() << ", " << total[j].share());
    CHECK(first[j].hits >= first[j].fewest(least));
    CHECK(total[j].hits >= total[j].fewest(least));
    CHECK(first[j].hits <= first[j].most(most));
    CHECK(total[j].hits <= total[j].most(most));
  }
}

// Plain Monte Carlo has a 95 % half width of about 2 c / sqrt(blocks) with c <= 1.5 for these
// functions; evenly spread points must do no worse.
double monte_carlo_half_width(std::uint64_t blocks) {
  return 3 / std::sqrt(static_cast<double>(blocks));
}

}  // namespace

TEST_CASE("Sobol indices of the Ishigami function", "[studies][sobol]") {
  check_within(ishigami_function(), 4096, monte_carlo_half_width(4096));
  const SobolIndices indices = measured(ishigami_function(), 4096, 1);
  CHECK(indices.blocks() == 4096);
  // Exact values 3.5 and 13.844587940719; five standard errors of plain random points, sd / 64 of the
  // mean and sqrt(kurtosis - 1 = 2.5) V / 64 of the variance, over both points of a block.
  CHECK(indices.mean() == Approx(3.5).margin(5 * 3.72 / 64));
  CHECK(indices.variance() == Approx(13.844587940719).margin(5 * 1.6 * 13.84 / 64));
}

TEST_CASE("Sobol indices of the g function", "[studies][sobol]") {
  check_within(g_function(), 4096, monte_carlo_half_width(4096));
}

// The truth lies in a 95 % interval in 92 to 98 % of the seeds: Student's t is not exact for a ratio,
// nor are replicates of evenly spread points normal. The band is the binomial one of these coverages.
TEST_CASE("intervals of Sobol indices cover the truth", "[studies][sobol]") {
  check_coverage(ishigami_function(), 512, 200, 0.92, 0.985);
  check_coverage(g_function(), 256, 200, 0.92, 0.985);
}

TEST_CASE("intervals of Sobol indices cover the truth over two thousand seeds",
          "[studies][sobol][.long]") {
  for (const std::uint64_t blocks : {256U, 1024U, 4096U}) {
    CAPTURE(blocks);
    check_coverage(ishigami_function(), blocks, 2000, 0.93, 0.985);
    check_coverage(g_function(), blocks, 2000, 0.93, 0.985);
  }
}

TEST_CASE("Sobol indices of sums and products have intervals that cover", "[studies][sobol]") {
  check_coverage(sum_function(), 256, 200, 0.92, 0.999);
  check_coverage(product_function(), 256, 200, 0.92, 0.999);
}

TEST_CASE("a sum shows no interactions beyond their interval", "[studies][sobol]") {
  // One of forty intervals lies above the truth by chance; 240 of them, of which those of a seed depend on each other.
  constexpr int kSeeds = 60;
  int claims = 0;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed)
    for (const SobolShares& one : measured(sum_function(), 256, seed).shares(0.95))
      claims += one.interactions.low > 1e-12 ? 1 : 0;
  CHECK(claims <= 16);
  // The product has some, which the interval shows.
  const auto shares = measured(product_function(), 1024, 1).shares(0.95);
  CHECK(shares[0].interactions.low > 0);
}

TEST_CASE("errors and coverage of Sobol indices over two hundred seeds",
          "[studies][sobol][.long]") {
  constexpr int kSeeds = 200;
  const std::vector<std::pair<const char*, Function>> functions{{"Ishigami", ishigami_function()},
                                                                {"g", g_function()},
                                                                {"sum", sum_function()},
                                                                {"product", product_function()}};
  for (const auto& [name, function] : functions) {
    const std::size_t d = function.first.size();
    std::vector<Coverage> covered(2);
    std::vector<double> squares(2, 0);
    for (unsigned seed = 0; seed < kSeeds; ++seed) {
      const auto shares = measured(function, 1024, 5000U + seed).shares(0.95);
      for (std::size_t j = 0; j < d; ++j) {
        covered[0].count(shares[j].first, function.first[j], 1e-12);
        covered[1].count(shares[j].total, function.total[j], 1e-9);
        squares[0] += std::pow(shares[j].first.value - function.first[j], 2);
        squares[1] += std::pow(shares[j].total.value - function.total[j], 2);
      }
    }
    const auto root = [&](double sum) {
      return std::sqrt(sum / (kSeeds * static_cast<double>(d)));
    };
    WARN(name << ": first " << root(squares[0]) << ", covered " << covered[0].share() << "; total "
              << root(squares[1]) << ", covered " << covered[1].share());
    for (const Coverage& one : covered) CHECK(one.hits >= one.fewest(0.93));
  }
}

TEST_CASE("intervals cover after rounds were doubled until they were narrow", "[studies][sobol]") {
  // Stopping when an interval happens to be narrow makes it a little too short: two thirds of
  // the missing 5 % more are conceded.
  const Function function = ishigami_function();
  Coverage first;
  Coverage total;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    std::uint64_t blocks = 256;
    while (blocks < 65536 && widest(measured(function, blocks, seed).shares(0.95)) > 0.15)
      blocks *= 2;
    const auto shares = measured(function, blocks, seed).shares(0.95);
    first.count(shares[0].first, function.first[0]);
    total.count(shares[2].total, function.total[2]);
  }
  INFO(first.share() << ", " << total.share());
  CHECK(first.hits >= first.fewest(0.917));
  CHECK(total.hits >= total.fewest(0.917));
}

TEST_CASE("a linear function has equal first and total indices", "[studies][sobol]") {
  Function linear;
  linear.value = [](std::span<const double> u) { return 1e6 + u[0] + 2 * u[1] + 3 * u[2]; };
  for (const double c : {1.0, 2.0, 3.0}) {
    linear.first.push_back(c * c / 14);
    linear.total.push_back(c * c / 14);
  }
  check_within(linear, 1024, monte_carlo_half_width(1024));
  // The variance of a sum of uniform numbers is sum c^2 / 12 = 7 / 6; five standard errors of random
  // points, and the offset of 1e6 costs 6 of 16 digits.
  CHECK(measured(linear, 1024, 1).variance() == Approx(14.0 / 12).epsilon(5 * 1.2 / 32));
}

TEST_CASE("an inert variable has indices of exactly zero", "[studies][sobol]") {
  Function function{[](std::span<const double> u) { return std::exp(u[0]) * u[2]; }, {0, 0, 0}, {}};
  const auto shares = measured(function, 256, 3).shares(0.95);
  for (const Estimate& e : {shares[1].first, shares[1].total}) {
    CHECK(e.value == 0);
    CHECK(e.low == 0);
    CHECK(e.high == 0);
  }
}

TEST_CASE("a function that does not vary has no indices", "[studies][sobol]") {
  // Rounding alone must not be shared out among the variables.
  for (const double noise : {0.0, 1e-13}) {
    Function function{[noise](std::span<const double> u) { return 3 + noise * u[0]; }, {0, 0}, {}};
    const SobolIndices indices = measured(function, 256, 3);
    CHECK(indices.constant());
    CHECK(std::isnan(indices.shares(0.95)[0].first.value));
    CHECK(std::isinf(widest(indices.shares(0.95))));
  }
}

TEST_CASE("failures drop whole blocks and leave the indices unbiased", "[studies][sobol]") {
  // Failures by chance, at any point of a block, say nothing about the function: indices stay right.
  const Function function = ishigami_function();
  const SobolDesign design(3, 5);
  SobolIndices indices(3);
  std::vector<double> u(3);
  std::vector<double> values(5);
  std::uint64_t failed = 0;
  for (std::uint64_t block = 0; block < 4096; ++block) {
    for (std::size_t m = 0; m < 5; ++m) {
      design.point(block, m, u);
      values[m] = ishigami(u);
    }
    twum::optim::Random random(17, 0, block);
    if (random.uniform() < 0.08) {
      values[random.below(5)] = std::numeric_limits<double>::quiet_NaN();
      ++failed;
    }
    indices.add(block, values);
  }
  CHECK(indices.dropped() == failed);
  CHECK(indices.blocks() + failed == 4096);
  const auto shares = indices.shares(0.999999);
  for (std::size_t j = 0; j < 3; ++j) {
    CHECK(shares[j].first.low <= function.first[j]);
    CHECK(shares[j].first.high >= function.first[j]);
    CHECK(shares[j].total.low <= function.total[j]);
    CHECK(shares[j].total.high >= function.total[j]);
  }
}

TEST_CASE("derivatives bound the total indices of the Ishigami function", "[studies][sobol]") {
  const SobolDesign design(3, 2);
  SobolIndices indices = measured(ishigami_function(), 4096, 2);
  std::vector<double> u(3);
  for (std::uint64_t block = 0; block < 4096; ++block) {
    design.point(block, 0, u);
    std::vector<double> x(3);
    for (std::size_t j = 0; j < 3; ++j) x[j] = kPi * (2 * u[j] - 1);
    std::vector<double> slope{std::cos(x[0]) * (1 + 0.1 * std::pow(x[2], 4)),
                              7 * std::sin(2 * x[1]), 0.4 * std::pow(x[2], 3) * std::sin(x[0])};
    for (double& s : slope) s *= 2 * kPi;  // by u
    indices.add_gradient(block, slope);
  }
  // E[(df/dx)^2] are 7.7195879407, 24.5 and 10.9873050694; over the range 2 pi, L^2 / pi^2 = 4.
  const double exact[] = {4 * 7.7195879407 / 13.844587940719, 4 * 24.5 / 13.844587940719,
                          4 * 10.9873050694 / 13.844587940719};
  const auto shares = indices.shares(0.999999);
  for (std::size_t j = 0; j < 3; ++j) {
    CHECK(shares[j].derivative_bound.low <= exact[j]);
    CHECK(shares[j].derivative_bound.high >= exact[j]);
    CHECK(shares[j].derivative_bound.value > shares[j].total.value);
  }
}

TEST_CASE("blocks are rounded up to what is evenly spread", "[studies][sobol]") {
  CHECK(SobolDesign::balanced(1) == 256);
  CHECK(SobolDesign::balanced(256) == 256);
  CHECK(SobolDesign::balanced(257) == 512);
  CHECK(SobolDesign::balanced(4096) == 4096);
}
