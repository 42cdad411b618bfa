// SPDX-License-Identifier: Apache-2.0
// Whichever call a request to stop comes in, also the last one of a stage, the answer says that it came.
#include "optim/inside/scaled_search.hpp"

#include <twum/optim/pareto.hpp>
#include <twum/optim/solve.hpp>

#include <catch2/catch.hpp>

using namespace twum;
using namespace twum::optim;
using test::D3;

TEST_CASE("a front that is stopped at any call says that it was", "[optim][pareto][budget]") {
  const Problem p = test::posed<3>(
      test::box(2, 0.0, 1.0, {0.5, 0.5}), {},
      [](const D3* x, D3* r) {
        const D3 g = (x[1] - 0.3) * (x[1] - 0.3);
        r[0] = x[0] * x[0] + g;
        r[1] = (x[0] - 1.0) * (x[0] - 1.0) + g;
      },
      2);
  ParetoOptions options;
  options.points = 3;
  options.coarse = 2;
  options.solve.starts = 2;
  const std::size_t all = pareto_front(p, options).counters.evaluations;
  REQUIRE(all > 20);
  for (std::size_t last = 1; last < all; ++last) {
    std::stop_source source;
    std::size_t calls = 0;
    options.solve.stop = source.get_token();
    options.solve.observer = [&](const Observation&) {
      if (++calls == last) source.request_stop();
    };
    const Front front = pareto_front(p, options);
    CAPTURE(last);
    CHECK(calls == last);
    CHECK(front.outcome == Outcome::budget);
    CHECK(front.stop == StopReason::requested);
  }
}

TEST_CASE("a solve that is stopped at any call says that it was", "[optim][solve][budget]") {
  Problem p = test::posed<3>(test::box(2, -2.0, 2.0, {-1.2, 1.0}), {}, [](const D3* x, D3* r) {
    const D3 a = x[1] - x[0] * x[0], b = 1.0 - x[0];
    r[0] = 100.0 * a * a + b * b;
  });
  for (const std::string solver : {"auto", "nlopt:slsqp"}) {
    SolveOptions options;
    options.solver = solver;
    options.starts = 3;
    const std::size_t all = solve(p, options).counters.evaluations;
    int cut = 0;
    for (std::size_t last = 1; last < all; ++last) {
      std::stop_source source;
      std::size_t calls = 0;
      options.stop = source.get_token();
      options.observer = [&](const Observation&) {
        if (++calls == last) source.request_stop();
      };
      const Result result = solve(p, options);
      CAPTURE(solver, last, all);
      CHECK(calls < all);
      // One of the starts may have led to an answer already, whose certificate the stop left whole.
      if (result.outcome == Outcome::optimal) {
        CHECK(result.certificate.passed);
        continue;
      }
      ++cut;
      CHECK(result.outcome == Outcome::budget);
      CHECK(result.stop == StopReason::requested);
    }
    CHECK(cut > 10);
  }
}
