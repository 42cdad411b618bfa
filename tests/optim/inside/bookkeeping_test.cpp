// SPDX-License-Identifier: Apache-2.0
// What a stage adds to the counts of its solve, and how an answer that a solver left is finished.
#include "search/stage_runner.hpp"

#include "optim/bank/posed.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace twum;
using namespace twum::optim;

namespace {

using D = Dual<double, 2>;
using Design = std::vector<double>;

// In a box whose start is off the least value of every function here.
template <typename F>
Problem in_box(F f) {
  return test::posed<2>(test::box(2, -2.0, 2.0, {1.0, -1.0}), {}, f);
}

// e^x - x + 2 y^2: at (1, -1) the slopes over the box are 4 (e - 1) and -16, and about the least value, at
// the origin, the slope in x is 4 x (1 + x / 2 + ...).
Problem skewed() {
  return in_box([](const D* x, D* r) { r[0] = exp(x[0]) - x[0] + 2.0 * x[1] * x[1]; });
}

// An answer as a solver would leave it, at `design`, with an end of its own.
struct Left {
  explicit Left(const Problem& given, const Design& design, const Design& own_end = {})
      : problem(given), scaling(problem) {
    const Design start = start_design(problem);
    scaling.scale_responses(start, problem.evaluate(start, true));
    run.session = std::make_unique<Session>(problem, options, deadline, 1, 1000);
    run.design = design;
    run.best =
        Candidate{scaling.to_unit(design), 0.0, 0.0, 0.0, problem.evaluate(design, false).values};
    run.final_design = own_end;
    finish_run(run, scaling);
  }
  const Certificate& certificate() const { return run.certified->certificate; }

  Problem problem;
  SolveOptions options;
  Deadline deadline{kInfinity};
  Scaling scaling;
  SolverRun run;
};

}  // namespace

TEST_CASE("a stage that is booked again adds what it used since", "[optim][definition]") {
  const Problem p = skewed();
  const SolveOptions options;
  const Deadline deadline(kInfinity);
  StageRunner runner(p, options, deadline);
  REQUIRE(runner.scale());
  const Counters before = runner.counters();
  SolverRun run;
  run.session = std::make_unique<Session>(p, options, deadline, runner.take_stage(), 100);
  const auto used = [&](std::size_t evaluations, std::size_t gradients, std::size_t reused) {
    runner.book(run);
    CHECK(runner.counters().evaluations - before.evaluations == evaluations);
    CHECK(runner.counters().gradients - before.gradients == gradients);
    CHECK(runner.counters().reused - before.reused == reused);
  };
  used(0, 0, 0);
  const Design here{0.1, 0.1}, there{0.2, 0.1}, far{0.9, 0.1};
  run.session->at(here, true);
  run.session->at(here, true);
  run.session->at(here, false);
  used(1, 1, 2);
  used(1, 1, 2);
  run.session->at(there, true);
  run.session->at(far, false);
  run.session->at(there, true);
  used(3, 2, 3);
  used(3, 2, 3);
}

TEST_CASE("an answer that passes but is not yet right to many digits is finished",
          "[optim][polish]") {
  // Beside (e, e) the larger of the scaled slopes is that in y, 16 e / 16 = e. It passes below 1e-6 and is left
  // alone below 1e-8; a Newton step from there leaves no more than rounding, and 1e-4 is near enough to
  // be mended by a few.
  for (const double e : {1e-9, 2e-7, 5e-7, 1e-4}) {
    const Left left(skewed(), {e, e});
    CAPTURE(e);
    REQUIRE(left.run.certified);
    CHECK(left.certificate().passed);
    CHECK(left.certificate().stationarity <= 1e-8);
    CHECK((left.run.design == Design{e, e}) == (e < 1e-8));
  }
}

TEST_CASE("where the best design cannot be finished, the solver's own end may be",
          "[optim][polish]") {
  // Newton steps from as far as (1.5, 1) are not taken; those from (1e-3, 1e-3) come to the origin.
  const Left without(skewed(), {1.5, 1.0});
  REQUIRE_FALSE(without.certificate().passed);
  const Left with(skewed(), {1.5, 1.0}, {1e-3, 1e-3});
  CHECK(with.certificate().passed);
  // The curvature in x is 1 in user units: a slope of 1e-6 / 4 * 16 is as far from the origin.
  CHECK(std::abs(with.run.design[0]) < 4e-6);
}

TEST_CASE("a nearer stationary point is taken even if it does not pass", "[optim][polish]") {
  // The saddle of x^2 - y^2, whose quadratic model is exact: one step leaves rounding alone.
  const Problem saddle = in_box([](const D* x, D* r) { r[0] = x[0] * x[0] - x[1] * x[1]; });
  const Left left(saddle, {0.01, 0.01});
  REQUIRE(left.run.certified);
  CHECK_FALSE(left.certificate().passed);
  CHECK(std::abs(left.run.design[0]) < 1e-9);
}
