// SPDX-License-Identifier: Apache-2.0
#include <twum/base/error.hpp>
#include <twum/optim/least_squares.hpp>
#include <twum/optim/random.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>
#include <string>
#include <vector>

using namespace twum;
using namespace twum::optim;

TEST_CASE("intervals cover the truth as often as they say",
          "[optim][least_squares][manufactured]") {
  const std::vector<Variable> line{{"b1", -kInfinity, kInfinity, 0.0},
                                   {"b2", -kInfinity, kInfinity, 0.0}};
  // A straight line with normal errors: the linearised interval is exact here.
  int covered = 0;
  const int repeats = 2000;
  for (int s = 0; s < repeats; ++s) {
    Random random(1, 2, static_cast<std::uint64_t>(s));
    std::vector<double> y;
    for (int i = 0; i < 8; ++i) {
      const double normal = std::sqrt(-2.0 * std::log(1.0 - random.uniform())) *
                            std::cos(6.283185307179586 * random.uniform());
      y.push_back(1.0 + 2.0 * i + 0.3 * normal);
    }
    const auto fit = least_squares(line, [&](std::span<const double> b) {
      Residuals r;
      for (std::size_t i = 0; i < 8; ++i) {
        r.values.push_back(b[0] + b[1] * static_cast<double>(i) - y[i]);
        r.jacobian.insert(r.jacobian.end(), {1.0, static_cast<double>(i)});
      }
      return r;
    });
    covered += fit.estimates[1].low <= 2.0 && 2.0 <= fit.estimates[1].high ? 1 : 0;
  }
  // Four standard errors of a proportion of 0.95 in 2000: 4 sqrt(0.95 * 0.05 / 2000) = 0.0195.
  CHECK(std::abs(covered / double(repeats) - 0.95) < 0.0195);
}

TEST_CASE("parameters that act only in combination are named",
          "[optim][least_squares][degenerate]") {
  std::vector<Variable> v{{"a", 0.1, 10.0, 1.0}, {"b", 0.1, 10.0, 1.0}, {"c", -10.0, 10.0, 0.0}};
  const auto fit = least_squares(v, [](std::span<const double> p) {
    Residuals r;
    for (int i = 0; i < 6; ++i) {
      r.values.push_back(p[0] * p[1] * i + p[2] - (3.0 * i + 1.0 + 0.01 * (i % 2)));
      r.jacobian.insert(r.jacobian.end(), {p[1] * i, p[0] * i, 1.0});
    }
    return r;
  });
  CHECK(fit.rank == 2);
  REQUIRE(fit.undetermined.size() == 1);
  CHECK(fit.undetermined[0] == std::vector<std::string>{"a", "b"});
  CHECK(std::isnan(fit.estimates[0].standard_deviation));
  CHECK(std::isfinite(fit.estimates[2].standard_deviation));
}

TEST_CASE("a bound holds a parameter, and the others are fitted as if it were known",
          "[optim][least_squares][bounds]") {
  std::vector<Variable> v{{"slope", 0.0, 1.5, 1.0}, {"offset", -10.0, 10.0, 0.0}};
  const auto fit = least_squares(v, [](std::span<const double> p) {
    Residuals r;
    for (int i = 0; i < 5; ++i) {
      r.values.push_back(p[0] * i + p[1] - 2.0 * i);
      r.jacobian.insert(r.jacobian.end(), {static_cast<double>(i), 1.0});
    }
    return r;
  });
  CHECK(fit.outcome == Outcome::optimal);
  CHECK(fit.estimates[0].value == 1.5);
  CHECK(fit.estimates[0].at_bound);
  // The mean of the remaining 0.5 i is 1; rounding of five terms.
  CHECK(fit.estimates[1].value == Approx(1.0).epsilon(1e-12));
  CHECK(fit.degrees_of_freedom == 4);
}

TEST_CASE("a fit whose parameters all end on bounds says so", "[optim][least_squares][bounds]") {
  // y = 5 x through points that want less than every range allows, or more.
  const double wanted = GENERATE(0.5, 50.0);
  const std::size_t count = GENERATE(1U, 2U);
  std::vector<Variable> v{{"slope", 1.0, 10.0, 5.0}};
  if (count == 2) v.push_back({"curvature", 1.0, 10.0, 5.0, Scale::log});
  const auto fit = least_squares(v, [&](std::span<const double> p) {
    Residuals r;
    for (const double x : {1.0, 2.0, 3.0}) {
      double y = p[0] * x;
      r.jacobian.push_back(x);
      if (count == 2) y += p[1] * x * x;
      if (count == 2) r.jacobian.push_back(x * x);
      r.values.push_back(y - wanted * (x + (count == 2 ? x * x : 0.0)));
    }
    return r;
  });
  CHECK(fit.word == "every parameter is held by a bound");
  CHECK(fit.degrees_of_freedom == 3);
  CHECK(fit.rank == 0);
  for (const auto& estimate : fit.estimates) {
    CHECK(estimate.at_bound);
    // Exact for a linear scale; exp(log(10)) is clamped to the bound.
    CHECK(estimate.value == (wanted < 1.0 ? 1.0 : 10.0));
    CHECK(estimate.low == estimate.value);
    CHECK(estimate.high == estimate.value);
  }
}

TEST_CASE("the interval of a log scale is that of the logarithm fitted linearly",
          "[optim][least_squares][identity]") {
  // log y = log a + b x: residuals of the logarithm are linear in log a.
  const double data[] = {0.9, 2.3, 3.1, 4.6, 4.4};
  const auto fitted = [&](bool log) {
    const Variable level = log ? Variable{"a", 1e-3, 1e3, 1.0, Scale::log}
                               : Variable{"log a", std::log(1e-3), std::log(1e3), 0.0};
    return least_squares({level, {"b", -10.0, 10.0, 0.0}}, [&](std::span<const double> p) {
      Residuals r;
      for (int i = 0; i < 5; ++i) {
        r.values.push_back((log ? std::log(p[0]) : p[0]) + p[1] * i - data[i]);
        r.jacobian.insert(r.jacobian.end(), {log ? 1.0 / p[0] : 1.0, static_cast<double>(i)});
      }
      return r;
    });
  };
  const auto a = fitted(true);
  const auto line = fitted(false);
  // Both end within 1e-9 of a step; the logarithm of the interval's ends is of order 1.
  CHECK(a.estimates[0].low == Approx(std::exp(line.estimates[0].low)).epsilon(1e-8));
  CHECK(a.estimates[0].high == Approx(std::exp(line.estimates[0].high)).epsilon(1e-8));
  CHECK(a.estimates[0].low > 0.0);
  CHECK(a.estimates[1].low == Approx(line.estimates[1].low).epsilon(1e-8));
  CHECK(a.student_t == Approx(3.182446305).epsilon(1e-9));  // tables: t of 3 degrees, 97.5 %
}

TEST_CASE("the mean of a few numbers has the spread of tables down to one degree of freedom",
          "[optim][least_squares][closed_form]") {
  const auto mean_of = [](const std::vector<double>& numbers) {
    return least_squares({{"mean", -10.0, 10.0, 0.0}}, [&](std::span<const double> p) {
      Residuals r;
      for (const double y : numbers) r.values.push_back(p[0] - y);
      r.jacobian.assign(numbers.size(), 1.0);
      return r;
    });
  };
  const auto two = mean_of({1.0, 3.0});
  CHECK(two.estimates[0].value == Approx(2.0).epsilon(1e-12));
  CHECK(two.degrees_of_freedom == 1);
  CHECK(two.residual_deviation == Approx(std::sqrt(2.0)).epsilon(1e-12));
  // tables: t of one degree, 97.5 %; it is tan(0.475 pi)
  CHECK(two.student_t == Approx(std::tan(0.475 * std::numbers::pi)).epsilon(1e-9));
  const auto one = mean_of({1.0});
  CHECK(one.degrees_of_freedom == 0);
  CHECK(std::isnan(one.residual_deviation));
  CHECK(std::isnan(one.student_t));
}

TEST_CASE("what follows a held parameter is what a fit with the bound elsewhere finds",
          "[optim][least_squares][derivative]") {
  const auto offset = [](double bound) {
    const std::vector<Variable> v{{"slope", 0.0, bound, 1.0}, {"offset", -10.0, 10.0, 0.0}};
    return least_squares(v, [](std::span<const double> p) {
      Residuals r;
      for (int i = 0; i < 5; ++i) {
        r.values.push_back(p[0] * i + p[1] - 2.0 * i);
        r.jacobian.insert(r.jacobian.end(), {static_cast<double>(i), 1.0});
      }
      return r;
    });
  };
  const auto fit = offset(1.5);
  // Linear: the difference quotient is exact to rounding, eps / 0.1. The mean of 0 to 4 is 2.
  const double slope = (offset(1.6).estimates[1].value - fit.estimates[1].value) / 0.1;
  CHECK(fit.follows[1 * 2 + 0] == Approx(slope).epsilon(1e-12));
  CHECK(slope == Approx(-2.0).epsilon(1e-12));
  CHECK(fit.follows[0 * 2 + 1] == 0.0);
}

TEST_CASE("a failed evaluation shortens the step and is counted",
          "[optim][least_squares][failure]") {
  const auto fit =
      least_squares({{"a", -100.0, 100.0, 0.0}}, [](std::span<const double> p) -> Residuals {
        if (p[0] > 3.0) throw EvaluationError("too-far", "beyond 3");
        return {{std::exp(p[0]) - 7.0, 0.0}, {std::exp(p[0]), 0.0}, ""};
      });
  CHECK(fit.outcome == Outcome::optimal);
  CHECK(fit.counters.failures.at("too-far") >= 1);
  CHECK(fit.estimates[0].value == Approx(std::log(7.0)).epsilon(1e-10));
}
