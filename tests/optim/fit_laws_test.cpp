// SPDX-License-Identifier: Apache-2.0
// Laws of a fit: units change its numbers and nothing else, more calls never make it worse, and its
// words say why it ended.
#include <twum/optim/least_squares.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace twum;
using namespace twum::optim;

namespace {

// y = slope x through the points (1, 2), (2, 4), (3, 6), each residual times `weight`.
ResidualFunction ray(double weight) {
  return [weight](std::span<const double> p) {
    Residuals r;
    for (const double x : {1.0, 2.0, 3.0}) {
      r.values.push_back(weight * (p[0] * x - 2.0 * x));
      r.jacobian.push_back(weight * x);
    }
    return r;
  };
}

// Rosenbrock's valley, 10 (b - a^2) and 1 - a, and a third residual that cannot vanish, with a and
// b in units of their own.
ResidualFunction valley(double unit_a, double unit_b) {
  return [=](std::span<const double> p) {
    const double a = p[0] / unit_a, b = p[1] / unit_b;
    return Residuals{{10.0 * (b - a * a), 1.0 - a, 0.5 * a + 1.0},
                     {-20.0 * a / unit_a, 10.0 / unit_b, -1.0 / unit_a, 0.0, 0.5 / unit_a, 0.0},
                     {}};
  };
}

LeastSquaresResult fit_valley(double unit_a, double unit_b, std::size_t calls) {
  LeastSquaresOptions options;
  options.max_evaluations = calls;
  return least_squares(
      {{"a", -kInfinity, kInfinity, -1.25 * unit_a}, {"b", -kInfinity, kInfinity, 1.0 * unit_b}},
      valley(unit_a, unit_b), options);
}

// Two parameters that all but replace each other; the first may not fall below zero.
ResidualFunction similar_parameters() {
  return [](std::span<const double> p) {
    Residuals r;
    for (int i = 0; i < 4; ++i) {
      const double second = 1.0 + 0.1 * i;
      r.values.push_back(p[0] + second * p[1] - (i == 0 ? 1.0 : 1.0 + 0.6 * i));
      r.jacobian.insert(r.jacobian.end(), {1.0, second});
    }
    return r;
  };
}

}  // namespace

TEST_CASE("weights common to all residuals leave what is held and where, to the last bit",
          "[optim][least_squares][bounds][scaling]") {
  // Wanted is 2: out of reach above or below, or inside with the start on either bound.
  const Variable ranges[] = {{"slope", 0.0, 1.5, 1.0},
                             {"slope", 3.0, 9.0, 4.0},
                             {"slope", 0.0, 5.0, 5.0},
                             {"slope", 1.0, 5.0, 1.0}};
  for (const Variable& range : ranges) {
    const double nearest = std::clamp(2.0, range.lower, range.upper);
    // A power of two changes no mantissa, so every step is the same.
    const auto plain = least_squares({range}, ray(1.0));
    const auto faint = least_squares({range}, ray(0x1p-20));
    CAPTURE(range.lower, range.upper, range.start);
    CHECK(faint.estimates[0].value == plain.estimates[0].value);
    // Linear and quadratically convergent: what is left is rounding.
    CHECK(faint.estimates[0].value == Approx(nearest).epsilon(1e-12));
    CHECK(faint.estimates[0].at_bound == (nearest != 2.0));
    CHECK(faint.counters.evaluations == plain.counters.evaluations);
    CHECK(faint.word == plain.word);
  }
}

TEST_CASE("the search is blind to the units of its parameters, to the last bit",
          "[optim][least_squares][scaling]") {
  for (const std::size_t calls : {1U, 2U, 5U, 10U, 2000U}) {
    // Powers of two change no mantissa.
    const double a = 0x1p12, b = 0x1p-4;
    const auto plain = fit_valley(1.0, 1.0, calls);
    const auto other = fit_valley(a, b, calls);
    CAPTURE(calls);
    CHECK(other.estimates[0].value == a * plain.estimates[0].value);
    CHECK(other.estimates[1].value == b * plain.estimates[1].value);
    CHECK(other.sum_of_squares == plain.sum_of_squares);
    CHECK(other.gradient == plain.gradient);
    CHECK(other.counters.evaluations == plain.counters.evaluations);
    CHECK(other.outcome == plain.outcome);
    CHECK((plain.gradient > 0.0 || calls > 10));  // the start and what follows it are no optima
  }
}

TEST_CASE("no fit makes more calls than it may, and more calls never make it worse",
          "[optim][least_squares][budget]") {
  double valley_before = kInfinity, similar_before = kInfinity;
  for (std::size_t calls = 1; calls < 40; ++calls) {
    CAPTURE(calls);
    const auto crooked = fit_valley(1.0, 1.0, calls);
    CHECK(crooked.counters.evaluations <= calls);
    CHECK(crooked.sum_of_squares <= valley_before);
    valley_before = crooked.sum_of_squares;
    LeastSquaresOptions options;
    options.max_evaluations = calls;
    const std::vector<Variable> both{{"first", 0.0, 10.0, 0.5}, {"second", -100.0, 100.0, 0.5}};
    const auto pressed = least_squares(both, similar_parameters(), options);
    CHECK(pressed.counters.evaluations <= calls);
    CHECK(pressed.sum_of_squares <= similar_before);
    similar_before = pressed.sum_of_squares;
  }
}

TEST_CASE("a fit that is asked to stop has run out of patience, not of ideas",
          "[optim][least_squares][budget]") {
  std::stop_source stop;
  LeastSquaresOptions options;
  options.stop = stop.get_token();
  int calls = 0;
  const ResidualFunction right = valley(1.0, 1.0);
  const auto fit = least_squares(
      {{"a", -10.0, 10.0, -1.25}, {"b", -10.0, 10.0, 1.0}},
      [&](std::span<const double> p) {
        if (++calls == 2) stop.request_stop();
        return right(p);
      },
      options);
  CHECK(calls == 2);
  CHECK(fit.outcome == Outcome::budget);
  CHECK(fit.word == "stopped on request");
}

TEST_CASE("a fit that ends on a kink is no optimum, and it was not the budget that ended it",
          "[optim][least_squares]") {
  // |x| + 1 falls towards x = 0 from both sides with slopes of one, so its cosine is one.
  const auto fit = least_squares({{"x", -10.0, 10.0, 2.0}}, [](std::span<const double> p) {
    return Residuals{{std::abs(p[0]) + 1.0}, {p[0] < 0.0 ? -1.0 : 1.0}, {}};
  });
  CHECK(fit.counters.evaluations < LeastSquaresOptions{}.max_evaluations);
  CHECK(fit.gradient == Approx(1.0).epsilon(1e-12));  // a quotient of equal numbers
  CHECK(fit.outcome == Outcome::feasible);
}

TEST_CASE("as many residuals as parameters leave no deviation, though they may not vanish",
          "[optim][least_squares][definition]") {
  // 1 + x^2 is least at its start x = 0.
  const auto fit = least_squares({{"x", -1.0, 1.0, 0.0}}, [](std::span<const double> p) {
    return Residuals{{1.0 + p[0] * p[0]}, {2.0 * p[0]}, {}};
  });
  CHECK(fit.sum_of_squares == 1.0);
  CHECK(fit.degrees_of_freedom == 0);
  CHECK(std::isnan(fit.residual_deviation));
  CHECK(std::isnan(fit.student_t));
}

TEST_CASE("a fit whose start alone can be evaluated stays there",
          "[optim][least_squares][failure]") {
  // So close to the optimum that no step could lower the sum by more than its rounding.
  for (const double start : {1e-7, 1e-2}) {
    const auto fit = least_squares({{"x", -1.0, 1.0, start}}, [&](std::span<const double> p) {
      if (p[0] != start) return Residuals{{}, {}, "torn"};
      return Residuals{{p[0], 1.0}, {1.0, 0.0}, {}};
    });
    CHECK(fit.estimates[0].value == start);
    CHECK(fit.sum_of_squares == Approx(1.0 + start * start).epsilon(1e-15));  // two operations
    CHECK(fit.counters.failures.at("torn") + 1 == fit.counters.evaluations);
    // The cosine is start / sqrt(1 + start^2), and 1e-5 passes.
    CHECK(fit.outcome == (start < 1e-5 ? Outcome::optimal : Outcome::feasible));
  }
}

TEST_CASE("a parameter that a bound holds counts as known: it does not deviate",
          "[optim][least_squares][bounds][definition]") {
  const auto fit = least_squares({{"slope", 0.0, 1.5, 1.0}}, ray(1.0));
  REQUIRE(fit.estimates[0].at_bound);
  CHECK(fit.estimates[0].standard_deviation == 0.0);
  CHECK(fit.covariance[0] == 0.0);
  CHECK(fit.estimates[0].low == 1.5);
  CHECK(fit.estimates[0].high == 1.5);
}

TEST_CASE("no start is an optimum for the units of its parameters", "[optim][least_squares]") {
  // A straight line far from its start: residuals 3, 5, 7, 9, cosines near one; a modulus in Pa and a length
  // in m have such units.
  for (const double unit : {1.0, 1e3, 1e6, 1e9}) {
    LeastSquaresOptions options;
    options.max_evaluations = 1;
    const auto fit = least_squares(
        {{"a", -kInfinity, kInfinity, 1.0 * unit}, {"b", -kInfinity, kInfinity, 1.0 / unit}},
        [&](std::span<const double> p) {
          Residuals r;
          for (int i = 0; i < 4; ++i) {
            r.values.push_back(p[0] / unit + p[1] * unit * i + 2.0 + i);
            r.jacobian.insert(r.jacobian.end(), {1.0 / unit, unit * i});
          }
          return r;
        },
        options);
    CAPTURE(unit, fit.gradient);
    CHECK(fit.outcome == Outcome::budget);
  }
}

TEST_CASE("a fixed parameter needs no residual", "[optim][least_squares][bounds]") {
  const auto fit =
      least_squares({{"known", 2.0, 2.0}, {"x", -1.0, 9.0, 0.0}}, [](std::span<const double> p) {
        return Residuals{{p[0] * p[1] - 6.0}, {p[1], p[0]}, {}};
      });
  CHECK(fit.outcome == Outcome::optimal);
  CHECK(fit.estimates[1].value == Approx(3.0).epsilon(1e-15));  // a division
}

TEST_CASE("residuals that were huge at the start do not make a fit optimal that was cut short",
          "[optim][least_squares][budget]") {
  // The first step takes x from 1 to rounding, 16 orders smaller, and halves y, which has 24 left to go.
  for (const std::size_t most : {2U, 3U}) {
    LeastSquaresOptions options;
    options.max_evaluations = most;
    const auto fit = least_squares(
        {{"x", -kInfinity, kInfinity, 1.0}, {"y", -kInfinity, kInfinity, 10.0}},
        [](std::span<const double> p) {
          return Residuals{{1e16 * p[0], p[1] * p[1] - 2.0}, {1e16, 0.0, 0.0, 2.0 * p[1]}, {}};
        },
        options);
    CAPTURE(most, fit.sum_of_squares);
    CHECK(fit.outcome == Outcome::budget);
  }
}

TEST_CASE("a fit in tiny units that was cut short is not optimal for that",
          "[optim][least_squares][budget]") {
  LeastSquaresOptions options;
  options.max_evaluations = 2;
  for (const double unit : {1.0, 1e-20}) {
    const auto fit = least_squares(
        {{"x", -kInfinity, kInfinity, 10.0}},
        [unit](std::span<const double> p) {
          return Residuals{{unit * (p[0] * p[0] - 2.0), unit}, {2.0 * unit * p[0], 0.0}, {}};
        },
        options);
    CAPTURE(unit, fit.gradient);
    CHECK(fit.outcome == Outcome::budget);
  }
}
