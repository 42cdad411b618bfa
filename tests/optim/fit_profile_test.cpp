// SPDX-License-Identifier: Apache-2.0
// Ends of intervals by the profile of the sum of squares, and the statistics behind the verdicts.
#include <twum/optim/fit_profile.hpp>
#include <twum/optim/lost_rank.hpp>

#include <catch2/catch.hpp>

#include <cmath>

using namespace twum::optim;

namespace {

constexpr double kNormal = 1.959963985;  // tables: 97.5 % of the normal law

// Residuals of known deviation 1.
LeastSquaresOptions known() {
  LeastSquaresOptions options;
  options.deviation = 1.0;
  return options;
}

// Four measurements of p^2 that have this mean, without scatter.
ResidualFunction squares(double mean) {
  return [mean](std::span<const double> p) {
    return Residuals{std::vector<double>(4, p[0] * p[0] - mean), std::vector<double>(4, 2.0 * p[0]),
                     ""};
  };
}

// y = slope x + offset at x = 0 ... 4, y = 1, 4, 3, 6, 9.
Residuals line(std::span<const double> p) {
  const double y[] = {1, 4, 3, 6, 9};
  Residuals r;
  for (int i = 0; i < 5; ++i) {
    r.values.push_back(p[0] * i + p[1] - y[i]);
    r.jacobian.insert(r.jacobian.end(), {static_cast<double>(i), 1.0});
  }
  return r;
}

}  // namespace

TEST_CASE("the linearised interval of a linear model stands (L3.1)",
          "[optim][least_squares][identity]") {
  const std::vector<Variable> v{{"slope", -10.0, 10.0, 0.0}, {"offset", -50.0, 50.0, 0.0}};
  const LeastSquaresOptions options;
  const auto fit = least_squares(v, line, options);
  for (const std::size_t j : {0U, 1U}) {
    const auto low = profile_end(v, line, options, fit, j, IntervalEnd::low);
    const auto high = profile_end(v, line, options, fit, j, IntervalEnd::high);
    CHECK(low.linear);
    CHECK(high.linear);
    CHECK_FALSE(low.cut_off);
    CHECK(low.better.empty());
    CHECK(low.value == Approx(fit.estimates[j].low).epsilon(1e-12));  // the same product
    CHECK(high.value == Approx(fit.estimates[j].high).epsilon(1e-12));
  }
}

TEST_CASE("a bent model has the interval that its sum of squares has (L3.1)",
          "[optim][least_squares][closed_form]") {
  // S = 4 (p^2 - 1)^2 exceeds 0 by t^2 where p^2 = 1 +- t / 2.
  const std::vector<Variable> v{{"p", 0.0, 10.0, 0.9}};
  const auto fit = least_squares(v, squares(1.0), known());
  REQUIRE(fit.estimates[0].value == Approx(1.0).epsilon(1e-9));
  const auto low = profile_end(v, squares(1.0), known(), fit, 0, IntervalEnd::low);
  const auto high = profile_end(v, squares(1.0), known(), fit, 0, IntervalEnd::high);
  CHECK_FALSE(low.linear);
  CHECK_FALSE(high.linear);
  // The root of S / t^2 is met within 1e-3; its slope 4 p / t is 0.29 at the low end and 2.9 at the high one.
  CHECK(low.value == Approx(std::sqrt(1.0 - kNormal / 2.0)).margin(1e-3 / 0.28));
  CHECK(high.value == Approx(std::sqrt(1.0 + kNormal / 2.0)).margin(1e-3 / 2.8));
  // z = 2 (p^2 - 1) / t along the whole profile, where its root is not one of rounding; the slope (L3.2) is exact.
  for (const auto& end : {low, high}) {
    REQUIRE(end.points.size() > 1);
    for (const ProfilePoint& point : end.points) {
      CHECK(point.z == Approx(2.0 * (point.value * point.value - 1.0) / kNormal).epsilon(1e-6));
      CHECK(point.slope == Approx(4.0 * point.value / kNormal).epsilon(1e-6));
    }
  }
  // Of a logarithm the interval is the same: the profile knows no scale.
  const std::vector<Variable> log{{"p", 0.05, 10.0, 0.9, Scale::log}};
  const auto again = least_squares(log, squares(1.0), known());
  CHECK(profile_end(log, squares(1.0), known(), again, 0, IntervalEnd::high).value ==
        Approx(high.value).margin(2e-3 / 2.8));
}

TEST_CASE("an interval ends at the bound where the data allow more",
          "[optim][least_squares][bounds]") {
  // p^2 = 0.5 - t / 2 < 0: no p is too small.
  const std::vector<Variable> v{{"p", 0.0, 1.0, 0.9}};
  const auto fit = least_squares(v, squares(0.5), known());
  const auto low = profile_end(v, squares(0.5), known(), fit, 0, IntervalEnd::low);
  CHECK(low.value == 0.0);
  CHECK(low.cut_off);
  const auto high = profile_end(v, squares(0.5), known(), fit, 0, IntervalEnd::high);
  CHECK(high.value == 1.0);  // sqrt(0.5 + t / 2) = 1.2
  CHECK(high.cut_off);
}

TEST_CASE("a better place on the way of a profile is handed back", "[optim][least_squares]") {
  // (p^2 - 4) / 4 and (p - 2) / 5 vanish at 2 and have another minimum near -2.
  const auto two = [](std::span<const double> p) {
    return Residuals{{(p[0] * p[0] - 4.0) / 4.0, (p[0] - 2.0) / 5.0}, {p[0] / 2.0, 0.2}, ""};
  };
  const std::vector<Variable> v{{"p", -5.0, 5.0, -3.0}};
  const auto fit = least_squares(v, two, known());
  REQUIRE(fit.estimates[0].value < 0.0);
  const auto high = profile_end(v, two, known(), fit, 0, IntervalEnd::high);
  REQUIRE(high.better.size() == 1);
  CHECK(high.better[0] > 0.0);
  CHECK(high.value > high.better[0]);
}

TEST_CASE("a known scatter stands in for the estimated one (L2.1, L2.2)",
          "[optim][least_squares][closed_form]") {
  const std::vector<Variable> v{{"slope", -10.0, 10.0, 0.0}, {"offset", -50.0, 50.0, 0.0}};
  // Sums about the mean of x: 10; the line is 1.8 x + 1, the residuals -0.0, 1.2, -1.6, -0.4, 0.8.
  const auto estimated = least_squares(v, line);
  CHECK(estimated.sum_of_squares == Approx(4.8).epsilon(1e-12));
  CHECK(estimated.scatter == Approx(std::sqrt(4.8 / 3.0)).epsilon(1e-12));
  // tables: F of 2 and 3 degrees of freedom, 95 %: 9.5521
  CHECK(estimated.joint_limit == Approx(4.8 + 2.0 * 1.6 * 9.5521).epsilon(1e-5));
  const auto given = least_squares(v, line, known());
  CHECK(given.scatter == 1.0);
  CHECK(given.student_t == Approx(kNormal).epsilon(1e-8));
  CHECK(given.estimates[0].standard_deviation == Approx(1.0 / std::sqrt(10.0)).epsilon(1e-12));
  // tables: chi-square of 2 degrees of freedom, 95 %: 5.99146
  CHECK(given.joint_limit == Approx(4.8 + 5.99146).epsilon(1e-5));
}

TEST_CASE("a product leaves the direction that keeps it unseen (L2.3)",
          "[optim][least_squares][closed_form]") {
  // Residuals 3 a b - 18 and a b + c - 10: (a, b) -> (a (1 + e), b (1 - e)) keeps both.
  const auto product = [](std::span<const double> p) {
    return Residuals{{3 * p[0] * p[1] - 18, p[0] * p[1] + p[2] - 10, p[2] - 4.5},
                     {3 * p[1], 3 * p[0], 0, p[1], p[0], 1, 0, 0, 1},
                     ""};
  };
  const auto fit = least_squares(
      {{"a", 0.1, 20.0, 2.0}, {"b", 0.1, 20.0, 2.5}, {"c", 0.0, 20.0, 4.0}}, product, known());
  REQUIRE(fit.directions.size() == 3);
  const Direction& least = fit.directions.front();
  CHECK(least.effect == Approx(0.0).margin(1e-12));  // rounding of columns of the size of 20
  CHECK(least.change[0] * least.change[1] == Approx(-1.0).epsilon(1e-9));
  CHECK(least.change[2] == Approx(0.0).margin(1e-9));
  // Each effect is the change of the residuals along its direction, here by the product rule.
  const double a = fit.estimates[0].value, b = fit.estimates[1].value, c = fit.estimates[2].value;
  for (const Direction& d : fit.directions) {
    const double ab = a * b * (d.change[0] + d.change[1]);
    const double dc = c * d.change[2];
    CHECK(d.effect == Approx(std::hypot(3 * ab, ab + dc, dc)).margin(1e-9));
  }
}

TEST_CASE("where the Jacobian lacks rank only at the fit, the profile still has its ends (L3.1)",
          "[optim][least_squares][closed_form]") {
  // S = 4 (p^2 + 1)^2 is least at 0, where its Jacobian 2 p is zero. It exceeds 4 by t^2 where p^2 = sqrt(1 + t^2 / 4) - 1.
  const std::vector<Variable> v{{"p", -3.0, 5.0, 0.0}};
  const auto fit = least_squares(v, squares(-1.0), known());
  REQUIRE(fit.undetermined.size() == 1);
  CHECK(lost_rank(v, squares(-1.0), known(), fit).empty());
  const double end = std::sqrt(std::sqrt(1.0 + kNormal * kNormal / 4.0) - 1.0);
  for (const IntervalEnd which : {IntervalEnd::low, IntervalEnd::high}) {
    const auto found = profile_end(v, squares(-1.0), known(), fit, 0, which);
    CHECK_FALSE(found.linear);
    CHECK_FALSE(found.cut_off);
    // z, the root of (S - 4) / t^2, is met within 1e-3. Its slope at the end, 8 p (p^2 + 1) / t^2 / z, is 1.84 there.
    CHECK(std::abs(found.value) == Approx(end).margin(1e-3 / 1.8));
    CHECK((found.value > 0.0) == (which == IntervalEnd::high));
  }
}

TEST_CASE("parameters that count only together everywhere stay so beside the fit",
          "[optim][least_squares]") {
  // 3 a b - 18 and a b - 6 know the product alone; c is known, and d moves nothing.
  const auto product = [](std::span<const double> p) {
    return Residuals{{3 * p[0] * p[1] - 18, p[0] * p[1] - 6, p[2] - 4.5, p[2] - 4.4},
                     {3 * p[1], 3 * p[0], 0, 0, p[1], p[0], 0, 0, 0, 0, 1, 0, 0, 0, 1, 0},
                     ""};
  };
  const std::vector<Variable> v{{"a", 0.1, 20.0, 2.0},
                                {"b", 0.1, 20.0, 2.5, Scale::log},
                                {"c", 0.0, 20.0, 4.0},
                                {"d", 0.0, 1.0, 0.5}};
  const auto fit = least_squares(v, product, known());
  REQUIRE(fit.undetermined.size() == 2);
  CHECK(lost_rank(v, product, known(), fit) == fit.undetermined);
}
