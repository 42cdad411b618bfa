// SPDX-License-Identifier: Apache-2.0
// Neighbouring residuals that are more alike than chance makes them (L4.1).
#include <twum/optim/neighbour_test.hpp>
#include <twum/optim/random.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <vector>

using namespace twum::optim;

namespace {

using Numbers = std::vector<double>;

Numbers normal_numbers(std::size_t count, Random& random) {
  Numbers list;
  for (std::size_t i = 0; i < count; ++i) {
    // Box and Muller; 1 - u is never 0.
    const double radius = std::sqrt(-2 * std::log(1 - random.uniform()));
    list.push_back(radius * std::cos(2 * std::numbers::pi * random.uniform()));
  }
  return list;
}

std::vector<std::size_t> in_order(std::size_t count) {
  std::vector<std::size_t> list(count);
  std::iota(list.begin(), list.end(), std::size_t{0});
  return list;
}

// Rows 1, x, x^2, ... of a polynomial at even places, row after row.
Numbers polynomial(std::size_t rows, std::size_t columns) {
  Numbers list;
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t j = 0; j < columns; ++j)
      list.push_back(std::pow(2 * static_cast<double>(i) / static_cast<double>(rows - 1) - 1,
                              static_cast<double>(j)));
  return list;
}

// What a polynomial leaves of the numbers: Gram and Schmidt, twice for rounding.
Residuals left_by(std::size_t columns, Numbers y) {
  Residuals left;
  const std::size_t m = y.size();
  left.jacobian = polynomial(m, columns);
  std::vector<Numbers> basis;
  const auto remove = [&](Numbers& from) {
    for (int twice = 0; twice < 2; ++twice) {
      for (const Numbers& one : basis) {
        const double part = std::inner_product(one.begin(), one.end(), from.begin(), 0.0);
        for (std::size_t i = 0; i < m; ++i) from[i] -= part * one[i];
      }
    }
  };
  for (std::size_t j = 0; j < columns; ++j) {
    Numbers column;
    for (std::size_t i = 0; i < m; ++i) column.push_back(left.jacobian[i * columns + j]);
    remove(column);
    const double size =
        std::sqrt(std::inner_product(column.begin(), column.end(), column.begin(), 0.0));
    for (double& one : column) one /= size;
    basis.push_back(column);
  }
  remove(y);
  left.values = y;
  return left;
}

double ratio(const Numbers& r, const std::vector<std::vector<std::size_t>>& series) {
  double differences = 0, squares = 0;
  for (const auto& one : series) {
    for (std::size_t i = 0; i < one.size(); ++i) {
      squares += r[one[i]] * r[one[i]];
      if (i > 0) differences += std::pow(r[one[i]] - r[one[i - 1]], 2);
    }
  }
  return differences / squares;
}

LeastSquaresResult with(std::size_t parameters) {
  LeastSquaresResult fit;
  fit.estimates.resize(parameters);
  return fit;
}

// p against the share of made errors whose residuals have as small a ratio.
void check_share(std::size_t rows, std::size_t columns,
                 const std::vector<std::vector<std::size_t>>& series, double drift) {
  Random random(rows, columns, 0);
  Numbers y = normal_numbers(rows, random);
  for (std::size_t i = 0; i < rows; ++i)
    y[i] += drift * std::sin(9 * static_cast<double>(i) / static_cast<double>(rows));
  const Residuals residuals = left_by(columns, y);
  const NeighbourTest found = neighbour_test(residuals, with(columns), series);
  const double here = ratio(residuals.values, series);
  constexpr int kTrials = 4000;
  int below = 0;
  for (int trial = 0; trial < kTrials; ++trial)
    if (ratio(left_by(columns, normal_numbers(rows, random)).values, series) <= here) ++below;
  CAPTURE(rows, columns, drift, here, found.p);
  // Four standard deviations of such a share; for the normal distribution of many numbers a tenth of p more.
  const double deviation = std::sqrt((found.p * (1 - found.p) + 1e-4) / kTrials);
  CHECK(found.p == Approx(static_cast<double>(below) / kTrials)
                       .margin(4 * deviation + (rows > 300 ? 0.1 * found.p : 0)));
}

}  // namespace

TEST_CASE("two residuals and three about their mean have ratios of known probability (L4.1)",
          "[optim][least_squares][closed_form]") {
  // Independent normal numbers (cos u, sin u), with every angle equally likely: the ratio is 1 - sin 2u.
  for (const double u : {0.1, 0.5, std::numbers::pi / 4, 1.0, 2.0, 2.3}) {
    const NeighbourTest found =
        neighbour_test({{std::cos(u), std::sin(u)}, {}, {}}, with(0), {{0, 1}});
    const double expected = 0.5 - std::asin(std::sin(2 * u)) / std::numbers::pi;
    CHECK(found.p == Approx(expected).margin(1e-9));
    CHECK(found.count == 2);
  }
  // Three less their mean lie in the plane of (1, 0, -1) / sqrt 2 and (1, -2, 1) / sqrt 6, where the sum of the squared
  // differences is that of the squares with the factors 1 and 3. A ratio of 2 - cos 2u has the angle u or less to the first: the
  // part 2 u / pi of all.
  for (const double u : {0.2, 0.7, 1.2}) {
    const double a = std::cos(u) / std::sqrt(2), b = std::sin(u) / std::sqrt(6);
    const NeighbourTest found =
        neighbour_test({{a + b, -2 * b, b - a}, {1, 1, 1}, {}}, with(1), {{0, 1, 2}});
    CHECK(found.p == Approx(2 * u / std::numbers::pi).margin(1e-9));
  }
}

TEST_CASE("probabilities of ratios are the shares of made errors (L4.1)",
          "[optim][least_squares][statistics]") {
  check_share(8, 2, {in_order(8)}, 0);
  check_share(20, 3, {in_order(20)}, 0.5);
  check_share(20, 3, {in_order(20)}, 1);
  check_share(20, 0, {in_order(20)}, 0.8);
  // Two series of a part of the residuals.
  check_share(24, 3, {{0, 1, 2, 3, 4, 5, 6}, {12, 13, 14, 15, 16, 17, 18, 19}}, 0.7);
  check_share(40, 4, {{3, 1, 5, 7, 9}, {0, 2, 4, 6, 8, 10, 12}}, 0.7);
  for (const double drift : {0.0, 0.2, 0.3}) check_share(320, 6, {in_order(320)}, drift);
}

TEST_CASE("random errors have every probability equally often (L4.1)",
          "[optim][least_squares][statistics]") {
  constexpr int kTrials = 1500;
  for (const std::size_t columns : {0U, 3U}) {
    Random random(columns, 5, 0);
    int rare = 0, unlikely = 0;
    for (int trial = 0; trial < kTrials; ++trial) {
      const Residuals residuals = left_by(columns, normal_numbers(14, random));
      const double p = neighbour_test(residuals, with(columns), {in_order(14)}).p;
      rare += p < 0.01 ? 1 : 0;
      unlikely += p < 0.05 ? 1 : 0;
    }
    // Four standard deviations of the binomial counts, 3.9 and 8.4.
    CHECK(std::abs(rare - 15) <= 16);
    CHECK(std::abs(unlikely - 75) <= 34);
  }
}

TEST_CASE("the probability of a ratio knows nothing of order, sign and size",
          "[optim][least_squares][identity]") {
  Random random(3, 0, 0);
  const Residuals base = left_by(2, normal_numbers(12, random));
  const auto p = [&](const Residuals& r, std::vector<std::vector<std::size_t>> series) {
    return neighbour_test(r, with(2), series).p;
  };
  const double here = p(base, {in_order(12)});
  std::vector<std::size_t> back = in_order(12);
  std::reverse(back.begin(), back.end());
  CHECK(p(base, {back}) == Approx(here).epsilon(1e-9));
  Residuals scaled = base;
  for (double& one : scaled.values) one *= -1e-5;
  for (double& one : scaled.jacobian) one *= 1e7;
  CHECK(p(scaled, {in_order(12)}) == Approx(here).epsilon(1e-9));
  CHECK(p(base, {{0, 1, 2, 3}, {4, 5, 6}, {7}}) ==
        Approx(p(base, {{6, 5, 4}, {0, 1, 2, 3}})).epsilon(1e-9));
}

TEST_CASE("residuals without neighbours or without a choice say nothing",
          "[optim][least_squares]") {
  CHECK(neighbour_test({{1, 2}, {}, {}}, with(0), {{0}, {1}}).p == 1);
  CHECK(neighbour_test({{1, 2}, {}, {}}, with(0), {}).count == 0);
  CHECK(neighbour_test({{0, 0}, {}, {}}, with(0), {{0, 1}}).p == 1);
  // Two less their mean are (1, -1) times a number, whatever the errors.
  CHECK(neighbour_test({{1, -1}, {1, 1}, {}}, with(1), {{0, 1}}).p == 1);
  // A parameter at a bound is known: it takes nothing from the errors.
  LeastSquaresResult held = with(1);
  held.estimates[0].at_bound = true;
  CHECK(neighbour_test({{1, -1}, {1, 1}, {}}, held, {{0, 1}}).p == Approx(1).epsilon(1e-9));
  CHECK(neighbour_test({{1, 1}, {1, 1}, {}}, held, {{0, 1}}).p == Approx(0).margin(1e-9));
}
