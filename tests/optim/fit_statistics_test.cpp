// SPDX-License-Identifier: Apache-2.0
// What a fit says of its parameters together: covariances, correlations, what follows a held one, and
// what the data leave open. The models are linear, so that all of it is known in closed form.
#include <twum/optim/least_squares.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <set>
#include <string>

using namespace twum::optim;

namespace {

// One residual: what the parameters' sum, each with its factor, should be.
struct Reading {
  std::vector<double> factors;
  double value;
};

ResidualFunction residuals_of(const std::vector<Reading>& readings) {
  return [&readings](std::span<const double> p) {
    Residuals r;
    for (const Reading& reading : readings) {
      double sum = -reading.value;
      for (std::size_t j = 0; j < p.size(); ++j) sum += reading.factors[j] * p[j];
      r.values.push_back(sum);
      r.jacobian.insert(r.jacobian.end(), reading.factors.begin(), reading.factors.end());
    }
    return r;
  };
}

Variable wide(const std::string& name) { return {name, -100.0, 100.0, 1.0}; }

// Covariances of linear models are s^2 times a constant matrix of a condition below 1e3 here, and s
// is flat in the parameters where the sum of squares is least: rounding is all that is left.
Approx rounded(double value) { return Approx(value).epsilon(1e-11).margin(1e-13); }

// The search ends when its steps are below 1e-9 of the parameters.
Approx searched(double value) { return Approx(value).epsilon(1e-8).margin(1e-8); }

// First, first + second and first + second + third, each measured a few times around a mean, in terms of
// the parameters (first, held, second, third). The held one is wanted at 2 and adds twice, -3 and 5 times
// itself to the three sums.
std::vector<Reading> steps() {
  const std::vector<double> first{1, 2, 0, 0}, second{1, -3, 1, 0}, third{1, 5, 1, 1};
  return {{first, 9},  {first, 11}, {second, 20}, {second, 21},      {second, 22},     {third, 42},
          {third, 39}, {third, 40}, {third, 39},  {{0, 1, 0, 0}, 2}, {{0, 1, 0, 0}, 2}};
}

}  // namespace

TEST_CASE("a straight line has the covariances of the textbook",
          "[optim][least_squares][closed_form]") {
  // x = 0 1 2 4 8 has the mean 3 and the sum of squares 40 about it. The errors 0 2 -3 1 0 are
  // orthogonal to 1 and to x, so they are the residuals of the line 5 + 7 x: s^2 = 14 / (5 - 2).
  const double x[] = {0, 1, 2, 4, 8};
  const double error[] = {0, 2, -3, 1, 0};
  std::vector<Reading> readings;
  for (std::size_t i = 0; i < 5; ++i) readings.push_back({{1.0, x[i]}, 5 + 7 * x[i] + error[i]});
  const auto fit = least_squares({wide("level"), wide("slope")}, residuals_of(readings));
  REQUIRE(fit.outcome == Outcome::optimal);
  CHECK(fit.estimates[0].value == searched(5.0));
  CHECK(fit.estimates[1].value == searched(7.0));
  CHECK(fit.rank == 2);
  CHECK(fit.undetermined.empty());
  const double s2 = 14.0 / 3.0;
  CHECK(fit.residual_deviation == rounded(std::sqrt(s2)));
  REQUIRE(fit.covariance.size() == 4);
  CHECK(fit.covariance[0] == rounded(s2 * (1.0 / 5.0 + 9.0 / 40.0)));
  CHECK(fit.covariance[1] == rounded(-s2 * 3.0 / 40.0));
  CHECK(fit.covariance[2] == rounded(-s2 * 3.0 / 40.0));
  CHECK(fit.covariance[3] == rounded(s2 / 40.0));
  CHECK(fit.estimates[0].standard_deviation == rounded(std::sqrt(s2 * (1.0 / 5.0 + 9.0 / 40.0))));
  CHECK(fit.estimates[1].standard_deviation == rounded(std::sqrt(s2 / 40.0)));
  REQUIRE(fit.correlation.size() == 4);
  // Minus the mean of x over its root mean square, which is sqrt(85 / 5).
  CHECK(fit.correlation[1] == rounded(-3.0 / std::sqrt(17.0)));
  CHECK(fit.correlation[2] == rounded(-3.0 / std::sqrt(17.0)));
  CHECK(fit.correlation[0] == 1.0);
  CHECK(fit.correlation[3] == 1.0);
  CHECK(fit.follows == std::vector<double>(4, 0.0));
}

TEST_CASE("units of a parameter change its numbers and nothing else",
          "[optim][least_squares][scaling]") {
  // Means of two pairs of readings; the second in units so large that its column is tiny.
  const double unit = GENERATE(1.0, 1e12);
  const std::vector<Reading> readings{
      {{1, 0}, 2}, {{1, 0}, 4}, {{1, 1 / unit}, 9}, {{1, 1 / unit}, 11}};
  const auto fit =
      least_squares({wide("level"), {"step", -kInfinity, kInfinity, 1.0}}, residuals_of(readings));
  CHECK(fit.rank == 2);
  CHECK(fit.undetermined.empty());
  CHECK(fit.estimates[1].value / unit == searched(7.0));
  // s^2 = 4 / 2; half of it for each mean.
  CHECK(fit.covariance[0] == rounded(1.0));
  CHECK(fit.covariance[1] / unit == rounded(-1.0));
  CHECK(fit.covariance[3] / unit / unit == rounded(2.0));
  CHECK(fit.correlation[1] == rounded(-1.0 / std::sqrt(2.0)));
}

TEST_CASE(
    "differences of means share the errors of what they have in common, around a held parameter",
    "[optim][least_squares][closed_form]") {
  // The free ones are u, v - u and w - v of independent means u, v, w of 2, 3 and 4 readings.
  const bool fixed = GENERATE(false, true);
  const Variable held{"held", fixed ? 0.5 : 0.0, 0.5, fixed ? 0.5 : 0.25};
  const auto readings = steps();
  const auto fit =
      least_squares({wide("first"), held, wide("second"), wide("third")}, residuals_of(readings));
  REQUIRE(fit.outcome == Outcome::optimal);
  CHECK(fit.estimates[1].value == 0.5);
  CHECK(fit.estimates[1].at_bound);
  // The means are 10, 21 and 40; half the held one's factors comes off.
  CHECK(fit.estimates[0].value == searched(10 - 1.0));
  CHECK(fit.estimates[2].value == searched(11 + 2.5));
  CHECK(fit.estimates[3].value == searched(19 - 4.0));
  // 2 + 2 + 6 about the means and 2 * 1.5^2 of the held one, with 11 - 3 degrees of freedom.
  CHECK(fit.sum_of_squares == rounded(14.5));
  CHECK(fit.degrees_of_freedom == 8);
  const double s2 = 14.5 / 8;
  const double u = s2 / 2, v = s2 / 3, w = s2 / 4;
  const std::vector<double> covariance{u,  0, -u,    0,   //
                                       0,  0, 0,     0,   //
                                       -u, 0, u + v, -v,  //
                                       0,  0, -v,    v + w};
  const double near = -u / std::sqrt(u * (u + v)), far = -v / std::sqrt((u + v) * (v + w));
  const std::vector<double> correlation{1,    0, near, 0,    //
                                        0,    1, 0,    0,    //
                                        near, 0, 1,    far,  //
                                        0,    0, far,  1};
  // The means stay: each free one makes up for what the held one adds to its difference.
  const std::vector<double> follows{0, -2, 0, 0, 0, 0, 0, 0, 0, 5, 0, 0, 0, -8, 0, 0};
  REQUIRE(fit.covariance.size() == covariance.size());
  REQUIRE(fit.correlation.size() == correlation.size());
  REQUIRE(fit.follows.size() == follows.size());
  for (std::size_t i = 0; i < covariance.size(); ++i) {
    CAPTURE(fixed, i);
    CHECK(fit.covariance[i] == rounded(covariance[i]));
    CHECK(fit.correlation[i] == rounded(correlation[i]));
    CHECK(fit.follows[i] == rounded(follows[i]));
  }
}

TEST_CASE("a parameter that no residual knows of is left open, and the others as without it",
          "[optim][least_squares][degenerate]") {
  // The mean of 1, 2 and 6 is 3, their squares about it sum up to 14.
  const std::vector<Reading> readings{{{0, 1}, 1}, {{0, 1}, 2}, {{0, 1}, 6}};
  const auto fit =
      least_squares({{"unused", -1.0, 1.0, 0.25}, wide("mean")}, residuals_of(readings));
  CHECK(fit.outcome == Outcome::optimal);
  CHECK(fit.rank == 1);
  CHECK(fit.undetermined == std::vector<std::vector<std::string>>{{"unused"}});
  CHECK(fit.estimates[0].value == 0.25);  // nothing moves it
  CHECK(fit.estimates[1].value == searched(3.0));
  CHECK(fit.degrees_of_freedom == 1);  // both parameters are free
  CHECK(fit.covariance[3] == rounded(14.0 / 3));
  CHECK(fit.correlation[3] == 1.0);
  for (const std::size_t open : {0U, 1U, 2U}) CHECK(std::isnan(fit.covariance[open]));
  for (const std::size_t open : {1U, 2U}) CHECK(std::isnan(fit.correlation[open]));
  CHECK(std::isnan(fit.estimates[0].standard_deviation));
  CHECK(std::isnan(fit.estimates[0].low));
  CHECK(std::isnan(fit.estimates[0].high));
}

TEST_CASE("where only a sum is determined, nothing is said to follow a held parameter",
          "[optim][least_squares][degenerate]") {
  const std::vector<Reading> readings{{{1, 1, 0, 1}, 3},
                                      {{1, 1, 0, 0}, 4},
                                      {{0, 0, 1, 1}, 5},
                                      {{0, 0, 1, 0}, 7},
                                      {{0, 0, 0, 1}, 90}};
  const auto fit = least_squares({wide("a"), wide("b"), wide("c"), {"held", 0.0, 1.0, 0.5}},
                                 residuals_of(readings));
  CHECK(fit.estimates[3].value == 1.0);
  CHECK(fit.rank == 2);
  CHECK(fit.undetermined == std::vector<std::vector<std::string>>{{"a", "b"}});
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      CAPTURE(i, j);
      const bool open = i < 2 || j < 2, known = i == 3 || j == 3;
      CHECK(std::isnan(fit.covariance[4 * i + j]) == (open && !known));
      CHECK(std::isnan(fit.correlation[4 * i + j]) == (open && !known && i != j));
      CHECK(std::isnan(fit.follows[4 * i + j]) == (i < 3 && j == 3));
    }
}

TEST_CASE("two columns count as one when the tangent of half their angle is below the tolerance",
          "[optim][least_squares][closed_form]") {
  // Unit columns at an angle t have the singular values sqrt(1 + cos t) and sqrt(1 - cos t).
  const double angle = 0.02;
  const std::vector<Reading> readings{
      {{1, 10 * std::cos(angle)}, 1}, {{0, 10 * std::sin(angle)}, 1}, {{0, 0}, 1}};
  const std::vector<Variable> parameters{{"a", -1e4, 1e4, 1.0}, {"b", -1e4, 1e4, 1.0}};
  LeastSquaresOptions options;
  options.rank_tolerance = 0.9 * std::tan(angle / 2);
  CHECK(least_squares(parameters, residuals_of(readings), options).rank == 2);
  options.rank_tolerance = 1.1 * std::tan(angle / 2);
  const auto fit = least_squares(parameters, residuals_of(readings), options);
  CHECK(fit.rank == 1);
  CHECK(fit.undetermined == std::vector<std::vector<std::string>>{{"a", "b"}});
}

TEST_CASE("a parameter without a start begins in the middle of its scale",
          "[optim][least_squares][closed_form]") {
  std::vector<double> first;
  least_squares({{"linear", 2.0, 10.0}, {"decades", 1.0, 100.0, std::nan(""), Scale::log}},
                [&](std::span<const double> p) -> Residuals {
                  if (first.empty()) first.assign(p.begin(), p.end());
                  return {{p[0] - 3.0, p[1] - 3.0}, {1, 0, 0, 1}, ""};
                });
  REQUIRE(first.size() == 2);
  CHECK(first[0] == 6.0);
  CHECK(first[1] == Approx(10.0).epsilon(1e-14));  // through a logarithm and back
}

TEST_CASE("where no residual knows of any parameter all are left open",
          "[optim][least_squares][degenerate]") {
  const std::vector<Reading> readings{{{0, 0}, 1}, {{0, 0}, 2}, {{0, 0}, 6}};
  const auto fit = least_squares({wide("a"), wide("b")}, residuals_of(readings));
  CHECK(fit.rank == 0);
  std::set<std::string> open;
  for (const auto& group : fit.undetermined) open.insert(group.begin(), group.end());
  CHECK(open == std::set<std::string>{"a", "b"});
  for (const double c : fit.covariance) CHECK(std::isnan(c));
  for (const Estimate& e : fit.estimates) CHECK(std::isnan(e.standard_deviation));
}
