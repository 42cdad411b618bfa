// SPDX-License-Identifier: Apache-2.0
#include "studies/statistics/coverage.hpp"

#include <catch2/catch.hpp>

#include <twum/studies/elementary_effects.hpp>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <set>
#include <span>
#include <vector>

namespace {

using namespace twum::studies;
using twum::test::Coverage;
using Function = std::function<double(std::span<const double>)>;

ElementaryEffects measured(const Function& f, std::size_t d, std::uint64_t trajectories,
                           std::uint64_t seed) {
  const MorrisDesign design(d, seed);
  ElementaryEffects effects(d);
  std::vector<double> points(d * (d + 1));
  std::vector<double> values(d + 1);
  for (std::uint64_t t = 0; t < trajectories; ++t) {
    for (std::size_t m = 0; m <= d; ++m) {
      const std::span<double> u(&points[m * d], d);
      design.point(t, m, u);
      values[m] = f(u);
    }
    effects.add(points, values);
  }
  return effects;
}

double ishigami(std::span<const double> u) {
  const auto x = [&](std::size_t j) { return std::numbers::pi * (2 * u[j] - 1); };
  const double s = std::sin(x(1));
  return std::sin(x(0)) + 7 * s * s + 0.1 * std::pow(x(2), 4) * std::sin(x(0));
}

}  // namespace

TEST_CASE("trajectories change each coordinate once, by two of four levels", "[studies][morris]") {
  const MorrisDesign design(4, 9);
  std::set<double> levels;
  for (std::uint64_t t = 0; t < 50; ++t) {
    std::set<std::size_t> moved;
    std::vector<double> before(4);
    design.point(t, 0, before);
    for (std::size_t m = 1; m <= 4; ++m) {
      std::vector<double> after(4);
      design.point(t, m, after);
      for (std::size_t j = 0; j < 4; ++j) {
        levels.insert(after[j]);
        if (after[j] == before[j]) continue;
        moved.insert(j);
        CHECK(std::abs(after[j] - before[j]) == Approx(2.0 / 3).epsilon(1e-15));
      }
      before = after;
    }
    CHECK(moved.size() == 4);
  }
  CHECK(levels == std::set<double>{0, 1.0 / 3, 2.0 / 3, 1});
}

TEST_CASE("elementary effects of a linear function are exact", "[studies][morris]") {
  const double slope[] = {3, -2, 0, 0.25};
  const auto f = [&](std::span<const double> u) {
    return 1 + slope[0] * u[0] + slope[1] * u[1] + slope[2] * u[2] + slope[3] * u[3];
  };
  const auto effects = measured(f, 4, 10, 1).effects(0.95);
  for (std::size_t j = 0; j < 4; ++j) {
    // Values of up to 5, rounded to 1e-15, over a step of 2/3.
    CHECK(effects[j].mu == Approx(slope[j]).margin(1e-14));
    CHECK(effects[j].mu_star.value == Approx(std::abs(slope[j])).margin(1e-14));
    CHECK(effects[j].sigma.value == Approx(0).margin(1e-14));
  }
  CHECK(effects[2].mu_star.value == 0);
  CHECK(effects[2].mu_star.high == 0);
  CHECK(effects[2].sigma.high == 0);
}

TEST_CASE("elementary effects of the Ishigami function", "[studies][morris]") {
  // On four levels sin^2 x_2 is 0, 3/4, 3/4, 0: the second effect is 7 * 0.75 / (2/3) in size, always;
  // sin x_1 is 0, -h, h, 0 with h = sqrt(3) / 2, hence the first is h (1 + 0.1 x_3^4) / (2/3), where
  // x_3^4 is pi^4 or pi^4 / 81; the third is 0 or 0.1 h (pi^4 - pi^4 / 81) / (2/3), equally often.
  const double h = std::sqrt(3.0) / 2 * 1.5;
  const double quartic = 0.1 * std::pow(std::numbers::pi, 4);
  const double first = h * (1 + quartic * (1 + 1.0 / 81) / 2);
  const double third = h * quartic * (1 - 1.0 / 81) / 2;
  const auto effects = measured(ishigami, 3, 4000, 1).effects(0.999999);
  CHECK(effects[1].mu_star.value == Approx(7.875).epsilon(1e-12));
  CHECK(effects[0].mu_star.low <= first);
  CHECK(effects[0].mu_star.high >= first);
  CHECK(effects[2].mu_star.low <= third);
  CHECK(effects[2].mu_star.high >= third);
  CHECK(effects[0].mu_star.high - effects[0].mu_star.low < 1.2);
}

TEST_CASE("intervals of elementary effects cover", "[studies][morris]") {
  // f = x_1 x_2: the first effect is x_2, at four levels: mean 1/2, variance 5/36.
  const auto product = [](std::span<const double> u) { return u[0] * u[1]; };
  Coverage mu_star;
  Coverage sigma;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const auto effects = measured(product, 2, 32, seed).effects(0.95);
    mu_star.count(effects[0].mu_star, 0.5);
    sigma.count(effects[0].sigma, std::sqrt(5.0) / 6);
  }
  INFO(mu_star.share() << ", " << sigma.share());
  // Draws of four values are not normal; at 32 of them both intervals are right to about 3 %.
  CHECK(mu_star.hits >= mu_star.fewest(0.92));
  CHECK(sigma.hits >= sigma.fewest(0.92));
}

TEST_CASE("a failure drops its trajectory", "[studies][morris]") {
  int calls = 0;
  const auto f = [&](std::span<const double> u) {
    return ++calls % 10 == 0 ? std::numeric_limits<double>::quiet_NaN() : 2 * u[0] + u[1];
  };
  const ElementaryEffects effects = measured(f, 2, 30, 1);
  CHECK(effects.dropped() == 9);
  CHECK(effects.trajectories() == 21);
  CHECK(effects.effects(0.95)[0].mu_star.value == Approx(2).epsilon(1e-14));
}
