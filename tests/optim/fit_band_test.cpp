// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include <twum/optim/fit_band.hpp>

#include <cmath>
#include <numbers>

namespace {

using namespace twum::optim;

// Ends are sought to 1e-3 of the rise, which is half as much of the half width.
constexpr double kAccurate = 2e-3;

TEST_CASE("the band of a linear fit is that of its covariance (L3.3, L2.4)",
          "[optim][fit][closed-form]") {
  // A line a + c x through readings at -1, 0 and 1: J^T J is diagonal with 3 and 2, and the prediction a + c x has the variance
  // 1/3 + x^2 / 2.
  const std::vector<Variable> parameters{{"a", -10, 10}, {"c", -10, 10}};
  const auto residuals = [](std::span<const double> b) {
    return Residuals{{b[0] - b[1] - 1, b[0] - 2, b[0] + b[1] - 3}, {1, -1, 1, 0, 1, 1}};
  };
  for (const double x : {0.0, 0.5, 2.0}) {
    const auto line = [x](std::span<const double> b) {
      return Prediction{b[0] + b[1] * x, {1, x}};
    };
    const double rise = 0.16, half = std::sqrt(rise * (1 / 3.0 + x * x / 2));
    const double at_fit[] = {2, 1};
    const auto low = band_end(parameters, residuals, line, at_fit, rise, IntervalEnd::low);
    const auto high = band_end(parameters, residuals, line, at_fit, rise, IntervalEnd::high);
    REQUIRE(low.has_value());
    REQUIRE(high.has_value());
    CHECK(line(*low).value == Approx(2 + x - half).margin(kAccurate * half));
    CHECK(line(*high).value == Approx(2 + x + half).margin(kAccurate * half));
  }
}

TEST_CASE("the band of a curved fit ends where its squares do (L3.3)",
          "[optim][fit][closed-form]") {
  // One reading of b^2, which is 4: S = (b^2 - 4)^2 is the rise at b = sqrt(4 +- sqrt(rise)), and so ends any rising number of b.
  const std::vector<Variable> parameters{{"b", 0.1, 10}};
  const auto residuals = [](std::span<const double> b) {
    return Residuals{{b[0] * b[0] - 4}, {2 * b[0]}};
  };
  const auto cube = [](std::span<const double> b) {
    return Prediction{std::pow(b[0], 3), {3 * b[0] * b[0]}};
  };
  const double at_fit[] = {2};
  const auto low = band_end(parameters, residuals, cube, at_fit, 9, IntervalEnd::low);
  const auto high = band_end(parameters, residuals, cube, at_fit, 9, IntervalEnd::high);
  REQUIRE(low.has_value());
  REQUIRE(high.has_value());
  CHECK((*low)[0] == Approx(1).epsilon(kAccurate));
  CHECK((*high)[0] == Approx(std::sqrt(7)).epsilon(kAccurate));
  // A range that ends earlier ends the band.
  const auto held = band_end({{"b", 1.5, 10}}, residuals, cube, at_fit, 9, IntervalEnd::low);
  REQUIRE(held.has_value());
  CHECK((*held)[0] == Approx(1.5));
}

TEST_CASE("the band follows a valley that is bent", "[optim][fit][closed-form]") {
  // Readings of b and of c - b^2 lie in a valley along a parabola. Of all motors the one with the largest c has
  // b = cos(t), c = b^2 + sin(t) 0.1 for the unit circle of the residuals: c is largest where 2 cos(t) sin(t) = 0.1 cos(t).
  const std::vector<Variable> parameters{{"b", -3, 3}, {"c", -3, 3}};
  const auto residuals = [](std::span<const double> b) {
    return Residuals{{b[0], (b[1] - b[0] * b[0]) / 0.1}, {1, 0, -20 * b[0], 10}};
  };
  const auto second = [](std::span<const double> b) { return Prediction{b[1], {0, 1}}; };
  const double at_fit[] = {0.0, 0.0}, near[] = {0.3, 0.09};
  const auto high = band_end(parameters, residuals, second, at_fit, 1, IntervalEnd::high, near);
  REQUIRE(high.has_value());
  // sin(t) = 0.05: c = 1 - sin^2 + 0.1 sin = 1.0025. The linearised band ends at 0.1.
  CHECK((*high)[1] == Approx(1.0025).epsilon(kAccurate));
}

}  // namespace
