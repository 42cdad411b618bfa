// SPDX-License-Identifier: Apache-2.0
// Solvers that are stopped at a design without an answer begin again from the best design, in a
// smaller box, which grows again when it holds the search back.
#include "optim/bank/dual_problem.hpp"

#include <twum/optim/solve.hpp>
#include <twum/optim/solvers.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

using namespace twum;
using namespace twum::optim;

namespace {

using D = Dual<double, 3>;
using Test = std::function<bool(std::span<const double>)>;

// Sum of weight_i (x_i - aim_i)^2 over the unit box, torn where `torn` says so.
Problem bowl(std::vector<double> weights, std::vector<double> aims, std::vector<double> start,
             Test torn) {
  Problem p;
  p.variables = test::box(start.size(), 0.0, 1.0, start);
  p.objectives = {{"f"}};
  p.evaluate = [=, n = start.size()](std::span<const double> x, bool) {
    if (torn(x)) return Evaluation{{}, {}, {}, "torn"};
    Evaluation e;
    e.values = {0.0};
    for (std::size_t i = 0; i < n; ++i) {
      const double t = x[i] - aims[i];
      e.values[0] += weights[i] * t * t;
      e.jacobian.push_back(2.0 * weights[i] * t);
    }
    return e;
  };
  return p;
}

struct Call {
  std::vector<double> design;
  bool ok;
  double value;
};

// The calls of the first run, which is that of the solver from the start.
std::vector<Call> first_run(const Problem& p, SolveOptions options) {
  std::vector<Call> calls;
  options.observer = [&](const Observation& o) {
    if (o.stage != 1) return;
    calls.push_back({{o.design.begin(), o.design.end()},
                     o.evaluation.ok(),
                     o.evaluation.ok() ? o.evaluation.values[0] : kInfinity});
  };
  options.analyse_infeasible = false;
  options.polish = false;
  solve(p, options);
  return calls;
}

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

// Of the designs that came right after a failed one, those that lie nearer to it than to the best.
std::size_t strays(const std::vector<Call>& calls, const std::vector<double>& start) {
  std::vector<double> best = start;
  double least = kInfinity;
  std::size_t count = 0;
  for (std::size_t i = 0; i + 1 < calls.size(); ++i) {
    if (calls[i].ok && calls[i].value < least) {
      least = calls[i].value;
      best = calls[i].design;
    }
    if (calls[i].ok) continue;
    const auto& next = calls[i + 1].design;
    // Half way is allowed; a few times the rounding of numbers below 1.
    if (distance(next, best) > distance(next, calls[i].design) + 1e-15) ++count;
  }
  return count;
}

}  // namespace

TEST_CASE("after a design that cannot be evaluated the search is nearer to the best one than to it",
          "[optim][failure]") {
  const std::vector<double> weights[] = {{1, 0, 0}, {0, 1, 0}, {1, 0.3, 0.1}, {0.05, 0.2, 1}};
  for (const auto& w : weights) {
    for (const bool upwards : {true, false}) {
      const double aim = upwards ? 0.7 : 0.3, from = upwards ? 0.2 : 0.8;
      const std::vector<double> start{from, from, from};
      const Problem p = bowl(w, {aim, aim, aim}, start, [=](std::span<const double> x) {
        return std::abs(x[0] - from) > 0.52 || std::abs(x[1] - from) > 0.52;
      });
      for (const std::string solver : {"nlopt:slsqp", "nlopt:lbfgs", "nlopt:ccsaq"}) {
        SolveOptions options;
        options.solver = solver;
        const auto calls = first_run(p, options);
        CAPTURE(w, upwards, solver);
        CHECK(strays(calls, start) == 0);
        double least = kInfinity;
        for (const Call& c : calls) least = std::min(least, c.value);
        // Of a value of 0.25 at the start, and weights of at least 0.05: within 1e-3 of the aim.
        CHECK(least < 1e-7);
      }
    }
  }
}

TEST_CASE("a box leaves out a failed design that is near", "[optim][failure]") {
  // x1 is pressed against its bound by a slope of 1, so the first step is the slope in x2, 0.35.
  for (const bool upwards : {true, false}) {
    const double from = upwards ? 0.2 : 0.8, aim = upwards ? 0.45 : 0.55;
    const std::vector<double> start{0.0, from};
    const Problem p = bowl({0.5, 0.7}, {-1.0, aim}, start,
                           [=](std::span<const double> x) { return std::abs(x[1] - from) > 0.3; });
    SolveOptions options;
    options.solver = "nlopt:slsqp";
    const auto calls = first_run(p, options);
    CAPTURE(upwards);
    CHECK(std::any_of(calls.begin(), calls.end(), [](const Call& c) { return !c.ok; }));
    CHECK(strays(calls, start) == 0);
  }
}

TEST_CASE("a box grows again where it holds the search back", "[optim][failure]") {
  // The first step leads past 0.95; half the way back is the wall of the box, short of 0.9.
  for (const bool upwards : {true, false}) {
    for (const std::size_t n : {1U, 2U, 3U}) {
      const double aim = upwards ? 0.9 : 0.1, from = upwards ? 0.05 : 0.95;
      std::vector<double> weights(n, 0.0), start(n, 0.5);
      for (std::size_t moving = 0; moving < n; ++moving) {
        weights.assign(n, 0.0);
        start.assign(n, 0.5);
        weights[moving] = 1.0;
        start[moving] = from;
        const Problem p =
            bowl(weights, std::vector<double>(n, aim), start,
                 [=](std::span<const double> x) { return std::abs(x[moving] - from) > 0.9; });
        SolveOptions options;
        options.solver = "nlopt:slsqp";
        const auto calls = first_run(p, options);
        CAPTURE(upwards, n, moving);
        bool failed = false;
        double least = kInfinity;
        for (const Call& c : calls) {
          failed = failed || !c.ok;
          least = std::min(least, c.value);
        }
        CHECK(failed);
        CHECK(least < 1e-10);  // of a parabola whose steps end at 1e-11 or below
      }
    }
  }
}

TEST_CASE("a best design without a derivative is left by a small step", "[optim][failure]") {
  for (const std::string solver : {"nlopt:slsqp", "nlopt:lbfgs", "nlopt:mma"}) {
    Problem p = bowl({1, 1}, {0.3, 0.8}, {0.6, 0.6}, [](std::span<const double>) { return false; });
    p.evaluate = [right = p.evaluate](std::span<const double> x, bool gradient) {
      Evaluation e = right(x, gradient);
      if (x[0] == 0.6 && x[1] == 0.6) e.jacobian[0] = std::numeric_limits<double>::quiet_NaN();
      return e;
    };
    SolveOptions options;
    options.solver = solver;
    const Result r = solve(p, options);
    CAPTURE(solver);
    CHECK(r.outcome == Outcome::optimal);
    // Curvature 2 and a stationarity of 1e-6 relative to the slope at the start, below 1.
    CHECK(std::abs(r.design[0] - 0.3) < 1e-6);
    CHECK(std::abs(r.design[1] - 0.8) < 1e-6);
  }
}

TEST_CASE("an exception of the evaluator ends a solve at once and reaches its caller",
          "[optim][failure]") {
  struct Torn {};
  for (const SolverInfo& solver : solvers()) {
    // Not available is NLopt's first DIRECT, which may crash when it is stopped among its first calls.
    if (!solver.available) continue;
    for (int fatal = 2; fatal < 9; ++fatal) {
      int calls = 0;
      Problem p;
      p.variables = test::box(2, -1.0, 2.0, {1.5, -0.5});
      p.objectives = {{"f"}};
      p.constraints = {{"sum", 1.0}, {"circle", -kInfinity, 4.0}, {"tie", 0.5, 0.5}};
      p.evaluate = [&, right = test::dual_evaluator<3>(4, [](const D* x, D* r) {
                         r[0] = x[0] * x[0] + 3.0 * x[1];
                         r[1] = x[0] + x[1];
                         r[2] = x[0] * x[0] + x[1] * x[1];
                         r[3] = x[0] * x[1];
                       })](std::span<const double> x, bool gradient) {
        if (++calls >= fatal) throw Torn();
        return right(x, gradient);
      };
      SolveOptions options;
      options.solver = solver.name;
      CAPTURE(solver.name, fatal);
      CHECK_THROWS_AS(solve(p, options), Torn);
      CHECK(calls == fatal);
    }
  }
}
