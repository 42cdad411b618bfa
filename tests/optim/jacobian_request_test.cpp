// SPDX-License-Identifier: Apache-2.0
// An evaluator may leave the Jacobian out where it is not asked for: whoever needs it asks.
#include "optim/bank/dual_problem.hpp"

#include <twum/optim/pareto.hpp>
#include <twum/optim/solve.hpp>

#include <catch2/catch.hpp>

#include <cmath>

using namespace twum;
using namespace twum::optim;

namespace {

using D = Dual<double, 2>;
using Design = std::vector<double>;

// Squared distances from (0, 0) and, in another unit, (1, 0), with x + y >= 0.5.
Problem generous(std::size_t objectives) {
  Problem p;
  p.variables = test::box(2, -2.0, 2.0, {1.0, 1.5});
  for (std::size_t k = 0; k < objectives; ++k) p.objectives.push_back({test::numbered('f', k)});
  p.constraints = {{"line", 0.5}};
  p.evaluate = test::dual_evaluator<2>(p.responses(), [objectives](const D* x, D* r) {
    r[0] = x[0] * x[0] + x[1] * x[1];
    if (objectives > 1) r[1] = 100.0 * ((x[0] - 1.0) * (x[0] - 1.0) + x[1] * x[1]);
    r[objectives] = x[0] + x[1];
  });
  return p;
}

Problem sparing(std::size_t objectives, std::size_t& without) {
  Problem p = generous(objectives);
  p.evaluate = [whole = p.evaluate, &without](std::span<const double> x, bool gradient) {
    Evaluation e = whole(x, gradient);
    if (!gradient) e.jacobian.clear(), ++without;
    return e;
  };
  return p;
}

void check_same(const Certificate& a, const Certificate& b) {
  CHECK(a.passed == b.passed);
  CHECK(a.stationarity == b.stationarity);
  CHECK(a.complementarity == b.complementarity);
  CHECK((a.curvature == b.curvature || (std::isnan(a.curvature) && std::isnan(b.curvature))));
  CHECK(a.weights == b.weights);
  CHECK(a.prices == b.prices);
  REQUIRE(a.limits.size() == b.limits.size());
  for (std::size_t i = 0; i < a.limits.size(); ++i)
    CHECK(a.limits[i].multiplier == b.limits[i].multiplier);
}

}  // namespace

TEST_CASE("answers are the same to the last bit if the Jacobian is given on request alone",
          "[optim][identity]") {
  std::size_t without = 0;
  for (const std::size_t objectives : {1U, 2U}) {
    for (const Design& design : {Design{0.25, 0.25}, Design{0.5, 0.0}, Design{1.0, 1.5}}) {
      const Certificate c = certify(sparing(objectives, without), design);
      check_same(c, certify(generous(objectives), design));
    }
  }
  const Result a = solve(sparing(1, without)), b = solve(generous(1));
  CHECK(a.outcome == Outcome::optimal);
  CHECK(a.design == b.design);
  CHECK(a.evaluation.values == b.evaluation.values);
  CHECK(a.certificate.curvature > 0.0);
  check_same(a.certificate, b.certificate);
  ParetoOptions options;
  options.points = 10;
  const Front few = pareto_front(sparing(2, without), options);
  const Front all = pareto_front(generous(2), options);
  CHECK(few.outcome == Outcome::optimal);
  CHECK(few.hypervolume == all.hypervolume);
  REQUIRE(few.points.size() == all.points.size());
  CHECK(few.points.size() == 10);
  for (std::size_t i = 0; i < all.points.size(); ++i) {
    CHECK(few.points[i].design == all.points[i].design);
    check_same(few.points[i].certificate, all.points[i].certificate);
  }
  // A search without derivatives asks for none but at its start and its end.
  SolveOptions blind;
  blind.solver = "nlopt:cobyla";
  without = 0;
  const Result found = solve(sparing(1, without), blind);
  CHECK(without > 10);
  CHECK(found.design == solve(generous(1), blind).design);
}
