// SPDX-License-Identifier: Apache-2.0
// Residuals condensed to a few that are the same to a fit of squares (L1.2).
#include "optim/normal.hpp"

#include <twum/optim/least_squares.hpp>
#include <twum/optim/random.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <vector>

using namespace twum::optim;
using twum::test::normal;

namespace {

constexpr double kEps = std::numeric_limits<double>::epsilon();

// exp(-rate x) * size at many places, with errors.
struct Decay {
  std::size_t count;
  double error;
  std::vector<double> noise{};

  Decay(std::size_t points, double size) : count(points), error(size) {
    Random random(7, 0, 0);
    for (std::size_t i = 0; i < count; ++i) noise.push_back(error * normal(random));
  }
  Residuals residuals(std::span<const double> b) const {
    Residuals r;
    for (std::size_t i = 0; i < count; ++i) {
      const double x = 3.0 * static_cast<double>(i) / static_cast<double>(count);
      const double e = std::exp(-b[1] * x);
      r.values.push_back(b[0] * e - 2.0 * std::exp(-0.7 * x) - noise[i]);
      r.jacobian.insert(r.jacobian.end(), {e, -b[0] * x * e});
    }
    return r;
  }
  LeastSquaresResult fit(bool few) const {
    return least_squares({{"size", 0.1, 10.0, 1.0}, {"rate", 0.01, 10.0, 1.0, Scale::log}},
                         [&](auto b) { return few ? condensed(residuals(b)) : residuals(b); });
  }
};

// Sums over the residuals: r^T r, J^T r and J^T J.
std::vector<double> products(const Residuals& r) {
  const std::size_t n = r.jacobian.size() / r.values.size();
  std::vector<double> sums((n + 1) * (n + 1), 0.0);
  for (std::size_t i = 0; i < r.values.size(); ++i) {
    const auto at = [&](std::size_t j) { return j < n ? r.jacobian[i * n + j] : r.values[i]; };
    for (std::size_t j = 0; j <= n; ++j)
      for (std::size_t k = 0; k <= n; ++k) sums[j * (n + 1) + k] += at(j) * at(k);
  }
  return sums;
}

}  // namespace

TEST_CASE("condensed residuals have the same sum of squares and products with the Jacobian (L1.2)",
          "[optim][least_squares][identity]") {
  for (const double size : {1.0, 1e-9}) {
    const Decay decay(500, size);
    const Residuals all = decay.residuals(std::vector<double>{2.0, 0.7});
    const Residuals few = condensed(all);
    CHECK(few.values.size() == 3);
    CHECK(few.count() == 500);
    const std::vector<double> there = products(all), here = products(few);
    // A reflection changes the length of a column by rounding, and each of the three adds its own; a sum of 500 products
    // rounds as often at most.
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k)
        CHECK(std::abs(here[3 * j + k] - there[3 * j + k]) <=
              1000 * kEps * std::sqrt(there[4 * j] * there[4 * k]));
  }
}

TEST_CASE(
    "residuals that are no more than one beyond the parameters, and failures, stay as they are",
    "[optim][least_squares]") {
  const Residuals three = Decay(3, 0.1).residuals(std::vector<double>{1.0, 1.0});
  CHECK(condensed(three).values == three.values);
  CHECK(condensed(three).jacobian == three.jacobian);
  CHECK(condensed({{}, {}, "no motor"}).failure == "no motor");
}

TEST_CASE("a fit of condensed residuals is that of all, intervals and degrees of freedom too",
          "[optim][least_squares]") {
  const Decay decay(400, 0.05);
  const LeastSquaresResult all = decay.fit(false), few = decay.fit(true);
  REQUIRE(all.outcome == Outcome::optimal);
  REQUIRE(few.outcome == Outcome::optimal);
  CHECK(few.degrees_of_freedom == 398);
  // Both end where the sum of squares changes by no more than 1e-13 of itself, so where the parameters are within the root of
  // that, 3e-7, of sqrt(398) = 20 deviations.
  for (std::size_t j = 0; j < 2; ++j) {
    const double deviation = all.estimates[j].standard_deviation;
    CHECK(std::abs(few.estimates[j].value - all.estimates[j].value) < 7e-6 * deviation);
    CHECK(few.estimates[j].standard_deviation == Approx(deviation).epsilon(1e-5));
    CHECK(few.estimates[j].rise == Approx(all.estimates[j].rise).epsilon(1e-5));
  }
  CHECK(few.joint_limit == Approx(all.joint_limit).epsilon(1e-9));
}
