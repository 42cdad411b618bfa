// SPDX-License-Identifier: Apache-2.0
// A solver of the program, beside those of the library.
#include "optim/bank/posed.hpp"

#include <twum/base/error.hpp>
#include <twum/optim/own_solver.hpp>
#include <twum/optim/solve.hpp>

#include <catch2/catch.hpp>

#include <algorithm>

using namespace twum;
using namespace twum::optim;
using Catch::Contains;

namespace {

using Number = Dual<double, 3>;

// Compares a point with its neighbours along each axis, and halves the steps where none is better.
void search_by_compass(const ScaledProblem& problem) {
  std::vector<double> here = problem.start;
  double best = problem.evaluate(here, false).value().objective;
  for (double step = 0.5; step > 1e-9;) {
    bool moved = false;
    for (std::size_t k = 0; k < here.size(); ++k)
      for (const double side : {-1.0, 1.0}) {
        std::vector<double> next = here;
        next[k] = std::clamp(next[k] + side * step, problem.lower[k], problem.upper[k]);
        const auto values = problem.evaluate(next, false);
        if (!values || !(values->objective < best)) continue;
        best = values->objective;
        here = next;
        moved = true;
      }
    if (!moved) step *= 0.5;
  }
}

// Steepest descent with a fixed step.
void descend(const ScaledProblem& problem) {
  std::vector<double> here = problem.start;
  for (int i = 0; i < 1000; ++i) {
    const auto values = problem.evaluate(here, true);
    for (std::size_t k = 0; k < here.size(); ++k) here[k] -= 0.2 * values.value().gradient[k];
  }
}

// The least of (x - 1)^2 + 2 (y + 0.5)^2 with y >= 0 on a box.
Problem shifted_bowl() {
  return test::posed<3>({{"x", -3.0, 3.0, 2.0}, {"y", 0.0, 3.0, 2.0}}, {},
                        [](const Number* x, Number* r) {
                          const Number a = x[0] - 1.0, b = x[1] + 0.5;
                          r[0] = a * a + 2.0 * b * b;
                        });
}

void add_once() {
  static const bool added = [] {
    add_solver({.name = "compass", .description = "along the axes"}, search_by_compass);
    add_solver({.name = "descent", .description = "steepest", .gradient = true}, descend);
    add_solver({.name = "endless", .description = "never returns"}, [](const ScaledProblem& p) {
      for (;;) (void)p.evaluate(p.start, false);
    });
    return true;
  }();
  CHECK(added);
}

}  // namespace

TEST_CASE("answers of own solvers are certified as those of any other", "[optim][own]") {
  add_once();
  for (const char* name : {"compass", "descent"}) {
    const Result r = solve(shifted_bowl(), {.solver = name});
    CAPTURE(name, r.certificate.reason);
    CHECK(r.outcome == Outcome::optimal);
    CHECK(r.solver == name);
    CHECK(r.design[0] == Approx(1.0).margin(1e-6));
    CHECK(r.design[1] == 0.0);
  }
  CHECK(find_solver("compass").description == "along the axes");
}

TEST_CASE("an own solver without gradients takes functions without derivatives", "[optim][own]") {
  add_once();
  Problem p = shifted_bowl();
  p.derivatives = false;
  const Result r = solve(p, {.solver = "compass"});
  CHECK(r.outcome == Outcome::feasible);
  CHECK(r.design[0] == Approx(1.0).margin(1e-6));
  CHECK_THROWS_WITH(solve(p, {.solver = "descent"}), Contains("needs derivatives"));
}

TEST_CASE("budget, stop and errors end an own solver", "[optim][own]") {
  add_once();
  std::stop_source stop;
  SolveOptions options{.solver = "endless", .stop = stop.get_token()};
  std::size_t calls = 0;
  options.observer = [&](const Observation&) {
    if (++calls == 3) stop.request_stop();
  };
  const Result stopped = solve(shifted_bowl(), options);
  CHECK(stopped.counters.evaluations < 100);
  // It evaluates one point for ever; the calls of a local search end it.
  CHECK(solve(shifted_bowl(), {.solver = "endless"}).certificate.passed == false);
  Problem broken = shifted_bowl();
  broken.evaluate = [](std::span<const double>, bool) -> Evaluation {
    throw std::runtime_error("no licence");
  };
  CHECK_THROWS_WITH(solve(broken, {.solver = "compass"}), "no licence");
}

TEST_CASE("names of own solvers are their own", "[optim][own]") {
  add_once();
  for (const char* name : {"", "auto", "nlopt:slsqp", "compass"})
    CHECK_THROWS_AS(add_solver({.name = name}, descend), InputError);
  CHECK_THROWS_AS(add_solver({.name = "none"}, nullptr), InputError);
}
