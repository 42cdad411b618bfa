// SPDX-License-Identifier: Apache-2.0
// Every solver of fits, on the same problems under bounds.
#include <twum/base/error.hpp>
#include <twum/optim/least_squares.hpp>
#include <twum/optim/random.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <vector>

using namespace twum;
using namespace twum::optim;

namespace {

constexpr int kPoints = 9;
constexpr int kParameters = 4;

// A linear fit with one optimum, whatever the bounds.
struct LinearFit {
  std::vector<double> matrix, right;
  std::vector<Variable> ranges;

  explicit LinearFit(std::uint64_t number) {
    Random random(7, 1, number);
    for (int i = 0; i < kPoints * kParameters; ++i) matrix.push_back(random.uniform() - 0.5);
    for (int i = 0; i < kPoints; ++i) right.push_back(4 * random.uniform() - 2);
    for (int j = 0; j < kParameters; ++j) {
      const double low = -random.uniform();
      const double high = random.uniform();
      ranges.push_back({"b" + std::to_string(j), low, high, 0.5 * (low + high)});
    }
  }

  Residuals operator()(std::span<const double> b) const {
    Residuals r;
    for (int i = 0; i < kPoints; ++i) {
      double value = -right[static_cast<std::size_t>(i)];
      for (int j = 0; j < kParameters; ++j)
        value +=
            matrix[static_cast<std::size_t>(i * kParameters + j)] * b[static_cast<std::size_t>(j)];
      r.values.push_back(value);
    }
    r.jacobian = matrix;
    return r;
  }

  // Half the derivative of the sum of squares.
  double slope(const std::vector<double>& b, int j) const {
    const Residuals r = (*this)(b);
    double sum = 0;
    for (int i = 0; i < kPoints; ++i)
      sum += matrix[static_cast<std::size_t>(i * kParameters + j)] *
             r.values[static_cast<std::size_t>(i)];
    return sum;
  }
};

LeastSquaresOptions with_solver(const std::string& name) {
  LeastSquaresOptions options;
  options.solver = name;
  return options;
}

std::vector<SolverInfo> usable() {
  std::vector<SolverInfo> list = least_squares_solvers();
  std::erase_if(list, [](const SolverInfo& one) { return !one.available; });
  return list;
}

}  // namespace

TEST_CASE("at the end of a fit under bounds no parameter can go where the sum of squares falls",
          "[optim][least_squares][bounds]") {
  for (const SolverInfo& solver : usable()) {
    CAPTURE(solver.name);
    int held = 0;
    for (std::uint64_t number = 0; number < 300; ++number) {
      const LinearFit problem(number);
      const auto fit = least_squares(problem.ranges, problem, with_solver(solver.name));
      CAPTURE(number, fit.word);
      CHECK(fit.outcome == Outcome::optimal);
      std::vector<double> b;
      for (const Estimate& one : fit.estimates) b.push_back(one.value);
      for (int j = 0; j < kParameters; ++j) {
        const double slope = problem.slope(b, j);
        const Variable& range = problem.ranges[static_cast<std::size_t>(j)];
        const double at = b[static_cast<std::size_t>(j)];
        // A sum of squares of up to 9 * 4^2 is known to 3e-14. Down a slope g, of a column whose square is at most
        // 9 * 0.25, it can fall by g^2 / 2.25, which is seen from g = 2.7e-7 on.
        if (at == range.lower)
          CHECK(slope > -2.7e-7);
        else if (at == range.upper)
          CHECK(slope < 2.7e-7);
        else
          CHECK(std::abs(slope) < 2.7e-7);
        held += at == range.lower || at == range.upper ? 1 : 0;
      }
    }
    CHECK(held > 300);  // bounds matter: one of the four is held on average
  }
}

TEST_CASE("a place without residuals shortens the step of every solver of fits",
          "[optim][least_squares][failure]") {
  // The first step of an undamped method from 0.05 leads to 20, where there are no residuals.
  for (const SolverInfo& solver : usable()) {
    CAPTURE(solver.name);
    const auto fit = least_squares(
        {{"x", 0.0, 100.0, 0.05}},
        [](std::span<const double> p) {
          Residuals r;
          if (p[0] > 3) r.failure = "too far";
          r.values = {p[0] * p[0] - 4, 0.5 * (p[0] - 2)};
          r.jacobian = {2 * p[0], 0.5};
          return r;
        },
        with_solver(solver.name));
    CHECK(fit.outcome == Outcome::optimal);
    CHECK(fit.estimates.front().value == Approx(2.0).epsilon(1e-12));
    CHECK(fit.counters.failures.contains("too far"));
  }
}

TEST_CASE("an exception of the residuals leaves every solver of fits",
          "[optim][least_squares][error]") {
  for (const SolverInfo& solver : usable()) {
    CAPTURE(solver.name);
    int calls = 0;
    const auto torn = [&](std::span<const double> p) {
      if (++calls > 2) throw InputError("the bench is on fire");
      Residuals r;
      r.values = {std::exp(p[0]) - 3, p[0]};
      r.jacobian = {std::exp(p[0]), 1};
      return r;
    };
    CHECK_THROWS_WITH(least_squares({{"x", -9.0, 9.0, 4.0}}, torn, with_solver(solver.name)),
                      "the bench is on fire");
  }
}

TEST_CASE("an unknown solver of fits is refused", "[optim][least_squares][error]") {
  const LinearFit problem(0);
  CHECK_THROWS_WITH(least_squares(problem.ranges, problem, with_solver("lm")),
                    "unknown solver 'lm' of a fit; there are twum:lm and gsl:lm");
  for (const SolverInfo& solver : least_squares_solvers()) {
    if (solver.available) continue;
    CHECK_THROWS_WITH(least_squares(problem.ranges, problem, with_solver(solver.name)),
                      "solver '" + solver.name + "' cannot be used: " + solver.description);
  }
}
