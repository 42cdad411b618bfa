// SPDX-License-Identifier: Apache-2.0
// How an optimum moves with what its problem holds fixed (L5.2, L5.3): closed forms, and solving again.
#include <twum/optim/optimum_moves.hpp>
#include <twum/optim/solve.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

using namespace twum::optim;
using Catch::Matchers::Contains;

namespace {

// Values and gradients of the responses by the variables and then what is held.
struct Response {
  double value;
  std::vector<double> gradient;
};
using Responses = std::function<std::vector<Response>(std::span<const double>)>;

// A problem of the first `variables` entries or, wider, of all.
struct Posed {
  std::vector<Variable> variables;
  Objective objective;
  std::vector<Constraint> constraints;
  std::vector<double> held;
  Responses responses;

  Problem problem(bool wide) const {
    Problem p{variables, {objective}, constraints, {}};
    const std::size_t n = variables.size();
    for (std::size_t k = 0; wide && k < held.size(); ++k)
      p.variables.push_back({"held " + std::to_string(k), held[k], held[k]});
    p.evaluate = [this, n, wide](std::span<const double> x, bool) {
      std::vector<double> all(x.begin(), x.end());
      if (!wide) all.insert(all.end(), held.begin(), held.end());
      Evaluation e;
      for (const Response& r : responses(all)) {
        e.values.push_back(r.value);
        const auto count = static_cast<std::ptrdiff_t>(wide ? all.size() : n);
        e.jacobian.insert(e.jacobian.end(), r.gradient.begin(), r.gradient.begin() + count);
      }
      return e;
    };
    return p;
  }

  Result solved() const {
    SolveOptions options;
    options.tolerance = 1e-10;
    return solve(problem(false), options);
  }

  OptimumMoves moves() const { return moves_at(solved()); }

  OptimumMoves moves_at(const Result& found) const {
    REQUIRE(found.outcome == Outcome::optimal);
    std::vector<double> at = found.design;
    at.insert(at.end(), held.begin(), held.end());
    return optimum_moves(problem(true), at, held.size(), found.certificate);
  }
};

// The point of x + y <= 1 nearest to (p, 2 q).
Posed nearest() {
  return {{{"x", -5, 5}, {"y", -5, 5}},
          {"distance"},
          {{"sum", -kInfinity, 1.0}},
          {1.0, 0.5},
          [](std::span<const double> v) {
            const double a = v[0] - v[2];
            const double b = v[1] - 2 * v[3];
            return std::vector<Response>{{a * a + b * b, {2 * a, 2 * b, -2 * a, -4 * b}},
                                         {v[0] + v[1], {1, 1, 0, 0}}};
          }};
}

// The largest p x^a y with a x^2 + y^3 / q <= p, x on a log scale: no closed form.
Posed curved() {
  return {{{"x", 0.01, 10, 1.0, Scale::log}, {"y", 0.1, 10, 1.0}},
          {"yield", Sense::maximize},
          {{"cost", -kInfinity, 0.0}},
          {2.0, 1.5, 0.7},
          [](std::span<const double> v) {
            const double x = v[0], y = v[1], p = v[2], q = v[3], a = v[4];
            const double f = p * std::pow(x, a) * y;
            return std::vector<Response>{
                {f, {a * f / x, f / y, f / p, 0, f * std::log(x)}},
                {a * x * x + y * y * y / q - p,
                 {2 * a * x, 3 * y * y / q, -1, -y * y * y / (q * q), x * x}}};
          }};
}

}  // namespace

TEST_CASE("the nearest point of a line moves as geometry says (L5.2, L5.3)",
          "[optim][moves][closed_form]") {
  // (p, 2 q) less t (1, 1), t = (p + 2 q - 1) / 2; the distance is 2 t^2.
  const Posed posed = nearest();
  const OptimumMoves moves = posed.moves();
  CHECK(moves.reason.empty());
  REQUIRE(moves.design.size() == 4);
  const double t = (posed.held[0] + 2 * posed.held[1] - 1) / 2;
  // Differences of gradients that are linear: rounding over steps of 1e-4, and the search's 1e-10.
  const auto near = [](double value) { return Approx(value).epsilon(1e-8).margin(1e-8); };
  CHECK(moves.design[0] == near(0.5));
  CHECK(moves.design[1] == near(-1.0));
  CHECK(moves.design[2] == near(-0.5));
  CHECK(moves.design[3] == near(1.0));
  CHECK(moves.objective[0] == near(2 * t));
  CHECK(moves.objective[1] == near(4 * t));
}

TEST_CASE("an optimum moves as solving again says (L5.2, L5.3)", "[optim][moves][derivative]") {
  const Posed posed = curved();
  const Result found = posed.solved();
  const OptimumMoves moves = posed.moves_at(found);
  REQUIRE(moves.objective.size() == 3);
  for (std::size_t k = 0; k < 3; ++k) {
    const double h = 1e-2 * posed.held[k];
    const auto at = [&](double factor) {
      Posed changed = posed;
      changed.held[k] += factor * h;
      const Result again = changed.solved();
      return std::vector<double>{again.design[0], again.design[1], again.evaluation.values[0]};
    };
    const auto a = at(-2), b = at(-1), c = at(1), d = at(2);
    for (std::size_t j = 0; j < 3; ++j) {
      CAPTURE(k, j);
      const double slope = (8 * (c[j] - b[j]) - (d[j] - a[j])) / (12 * h);
      const double said = j < 2 ? moves.design[j * 3 + k] : moves.objective[k];
      // Four points: of the order of (1e-2)^4, and the search's error over the step.
      CHECK(said == Approx(slope).epsilon(1e-5).margin(1e-6));
    }
  }
}

TEST_CASE("what a bound holds stays, and the rest moves along it (L5.2)",
          "[optim][moves][closed_form]") {
  Posed posed = nearest();
  posed.variables[1].upper = -1.0;  // then x = p alone, the sum is below 1
  const OptimumMoves moves = posed.moves();
  REQUIRE(moves.design.size() == 4);
  CHECK(moves.design[0] == Approx(1.0).epsilon(1e-8));
  CHECK(moves.design[1] == Approx(0.0).margin(1e-8));
  CHECK(moves.design[2] == 0.0);
  CHECK(moves.design[3] == 0.0);
  CHECK(moves.objective[1] == Approx(8 * posed.held[1] + 4).epsilon(1e-8));  // (-1 - 2 q)^2
}

TEST_CASE("where the optimum has no derivative the reason is said", "[optim][moves]") {
  SECTION("a limit without a multiplier") {
    Posed posed = nearest();
    posed.held = {0.25, 0.375};  // on the line
    CHECK_THAT(posed.moves().reason, Contains("sum"));
    CHECK(posed.moves().design.empty());
  }
  SECTION("a bound without a multiplier") {
    Posed posed = nearest();
    posed.constraints.front().upper = 10;
    posed.variables[0].upper = 1.0;  // p
    CHECK_THAT(posed.moves().reason, Contains("x is at an end of its range"));
  }
  SECTION("a valley") {
    Posed posed = nearest();
    posed.responses = [](std::span<const double> v) {
      const double a = v[0] + v[1] - v[2] + 0.5;
      return std::vector<Response>{{a * a, {2 * a, 2 * a, -2 * a, 0}},
                                   {v[0] - v[1], {1, -1, 0, 0}}};
    };
    CHECK_THAT(posed.moves().reason, Contains("x, y"));
  }
  SECTION("no optimum") {
    const Posed posed = nearest();
    Certificate none;
    CHECK_THAT(
        optimum_moves(posed.problem(true), std::vector<double>{0, 0, 1, 0.5}, 2, none).reason,
        Contains("not a certified optimum"));
  }
  SECTION("a kink") {
    Posed posed = nearest();
    posed.constraints.front().upper = 10;
    posed.responses = [](std::span<const double> v) {
      const double a = v[0] - v[2], b = v[1] - v[3];
      return std::vector<Response>{
          {std::fabs(a) + b * b, {a < 0 ? -1.0 : 1.0, 2 * b, a < 0 ? 1.0 : -1.0, -2 * b}},
          {v[0] + v[1], {1, 1, 0, 0}}};
    };
    const Result found = posed.solved();
    if (found.outcome == Outcome::optimal) CHECK(posed.moves_at(found).design.empty());
  }
}
