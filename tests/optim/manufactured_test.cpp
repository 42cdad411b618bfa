// SPDX-License-Identifier: Apache-2.0
#include "optim/bank/dual_problem.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <twum/optim/hypervolume.hpp>
#include <twum/optim/low_discrepancy.hpp>
#include <twum/optim/random.hpp>
#include <twum/optim/solve.hpp>

using namespace twum;
using namespace twum::optim;

namespace {

// min 1/2 |x|^2_Q + q x with rows a x <= b (the first `active` hold with equality at the optimum)
// built around a drawn optimum and drawn multipliers, so that both are known.
struct Manufactured {
  Problem problem;
  std::vector<double> optimum;
  std::vector<double> multipliers;
};

Manufactured draw(std::uint64_t seed) {
  Random random(seed, 11, 0);
  const auto uniform = [&](double a, double b) { return a + (b - a) * random.uniform(); };
  const std::size_t n = 2 + random.below(7);
  const std::size_t m = 1 + random.below(n);
  const std::size_t active = random.below(m + 1);
  Manufactured known;
  known.problem.variables = test::box(n, -10.0, 10.0);
  known.problem.objectives = {{"f"}};
  std::vector<double> curvature;
  std::vector<std::vector<double>> rows(m, std::vector<double>(n));
  for (std::size_t j = 0; j < n; ++j) {
    known.optimum.push_back(uniform(-3.0, 3.0));
    curvature.push_back(uniform(0.5, 5.0));
    known.problem.variables[j].start = uniform(-9.0, 9.0);
  }
  std::vector<double> gradient(n);  // of the quadratic at the optimum: minus the sum of l a
  for (std::size_t i = 0; i < m; ++i) {
    double value = 0.0;
    known.multipliers.push_back(i < active ? uniform(0.2, 3.0) : 0.0);
    for (std::size_t j = 0; j < n; ++j) {
      rows[i][j] = uniform(-1.0, 1.0);
      value += rows[i][j] * known.optimum[j];
      gradient[j] -= known.multipliers[i] * rows[i][j];
    }
    std::string name("c");
    name += std::to_string(i);
    known.problem.constraints.push_back(
        {name, -kInfinity, value + (i < active ? 0.0 : uniform(0.5, 2.0))});
  }
  known.problem.evaluate = [=, optimum = known.optimum](std::span<const double> x, bool) {
    Evaluation e;
    e.values.assign(1 + m, 0.0);
    e.jacobian.assign((1 + m) * n, 0.0);
    for (std::size_t j = 0; j < n; ++j) {
      const double d = x[j] - optimum[j];
      e.values[0] += 0.5 * curvature[j] * d * d + gradient[j] * d;
      e.jacobian[j] = curvature[j] * d + gradient[j];
      for (std::size_t i = 0; i < m; ++i) {
        e.values[1 + i] += rows[i][j] * x[j];
        e.jacobian[(1 + i) * n + j] = rows[i][j];
      }
    }
    return e;
  };
  return known;
}

}  // namespace

TEST_CASE("problems built around an optimum give it back, with its multipliers",
          "[optim][manufactured][certificate]") {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Manufactured known = draw(seed);
    SolveOptions options;
    options.starts = 2;
    const Result r = solve(known.problem, options);
    INFO("seed " << seed << " " << r.certificate.reason);
    REQUIRE(r.outcome == Outcome::optimal);
    // Stationarity 1e-6 of gradients up to about 50, over curvatures of at least 0.5.
    for (std::size_t j = 0; j < known.optimum.size(); ++j)
      CHECK(std::abs(r.design[j] - known.optimum[j]) < 1e-4);
    for (std::size_t i = 0; i < known.multipliers.size(); ++i)
      CHECK(std::abs(r.certificate.limits[i].multiplier - known.multipliers[i]) < 1e-3);
  }
}

TEST_CASE("the gain of a relaxed limit is that of a new solve",
          "[optim][manufactured][certificate]") {
  const Manufactured known = draw(7);
  const Result r = solve(known.problem);
  for (std::size_t i = 0; i < known.problem.constraints.size(); ++i) {
    const Activity& a = r.certificate.limits[i];
    if (!a.active) continue;
    Problem relaxed = known.problem;
    const double step = 0.01 * std::abs(a.limit);
    relaxed.constraints[i].upper += step;
    const double gained = solve(relaxed).evaluation.values[0] - r.evaluation.values[0];
    // First order: the second-order term is at most 1/2 step^2 curvature / |a|^2, here below
    // 10 step^2.
    CHECK(std::abs(gained - a.gain_per_percent) < 10.0 * step * step + 1e-9);
  }
}

TEST_CASE("an infeasible problem names its fighters and the smallest relaxation",
          "[optim][manufactured][infeasible]") {
  // x1 + x2 <= 1 and x1 + x2 >= 1 + gap fight; the third constraint looks on.
  const double gap = GENERATE(0.01, 0.5, 2.0);
  Problem p;
  p.variables = test::box(2, 0.0, 5.0);
  p.objectives = {{"f"}};
  p.constraints = {
      {"small", -kInfinity, 1.0}, {"large", 1.0 + gap, kInfinity}, {"inactive", -kInfinity, 100.0}};
  using D = Dual<double, 2>;
  p.evaluate = test::dual_evaluator<2>(4, [](const D* x, D* r) {
    r[0] = x[0] * x[0] + x[1];
    r[1] = x[0] + x[1];
    r[2] = x[0] + x[1];
    r[3] = x[0] * x[1];
  });
  for (const std::string solver : {"auto", "nlopt:slsqp"}) {
    SolveOptions options;
    options.solver = solver;
    const Result r = solve(p, options);
    INFO(solver << " gap " << gap);
    REQUIRE(r.outcome == Outcome::infeasible);
    CHECK(r.infeasibility.conflict == std::vector<std::string>{"small", "large"});
    REQUIRE(r.infeasibility.relaxations.size() == 2);
    // Solver tolerance 1e-9 of scaled rows, whose scale is 1/5.
    CHECK(std::abs(r.infeasibility.relaxations[0].amount + r.infeasibility.relaxations[1].amount -
                   gap) < 1e-6);
    CHECK(std::abs(r.infeasibility.relaxations[0].amount_alone - gap) < 1e-6);
    CHECK(std::abs(r.infeasibility.relaxations[1].amount_alone - gap) < 1e-6);
    CHECK(r.infeasibility.certified);
  }
}

TEST_CASE("the smallest relaxation of a curved pair of limits",
          "[optim][manufactured][infeasible]") {
  // The disc of radius 1 and the half plane x1 >= 2 are 1 apart: relaxing the plane alone takes 1,
  // the disc alone 2^2 - 1^2 = 3 (its response is the squared radius).
  Problem p;
  p.variables = test::box(2, -4.0, 4.0, {1.0, 1.0});
  p.objectives = {{"f"}};
  p.constraints = {{"disc", -kInfinity, 1.0}, {"plane", 2.0, kInfinity}};
  using D = Dual<double, 2>;
  p.evaluate = test::dual_evaluator<2>(3, [](const D* x, D* r) {
    r[0] = x[1];
    r[1] = x[0] * x[0] + x[1] * x[1];
    r[2] = x[0];
  });
  const Result r = solve(p);
  REQUIRE(r.outcome == Outcome::infeasible);
  for (const auto& relaxation : r.infeasibility.relaxations)
    CHECK(std::abs(relaxation.amount_alone - (relaxation.name == "disc" ? 3.0 : 1.0)) < 1e-5);
  CHECK(r.infeasibility.conflict.size() == 2);
}

TEST_CASE("log and linear scales find the same optimum in user units", "[optim][manufactured]") {
  Problem p;
  p.variables = test::box(1, 1e-4, 10.0, {1.0});
  p.objectives = {{"f", Sense::maximize}};
  using D = Dual<double, 2>;
  p.evaluate =
      test::dual_evaluator<2>(1, [](const D* x, D* r) { r[0] = x[0] * exp(-x[0] * 50.0); });
  p.variables[0].scale = Scale::log;
  const Result log = solve(p);
  CHECK(log.outcome == Outcome::optimal);
  CHECK(std::abs(log.design[0] - 0.02) < 1e-7);
  CHECK(log.evaluation.values[0] > 0.0);
}

TEST_CASE("hypervolumes of points counted by hand", "[optim][pareto][closed_form]") {
  CHECK(hypervolume({{1, 3}, {2, 2}, {3, 1}}, {4, 4}) == 6.0);
  CHECK(hypervolume({{3, 1}, {1, 3}, {2, 2}, {2, 2}, {2.5, 2.5}, {5, 0}}, {4, 4}) == 6.0);
  CHECK(hypervolume({}, {4, 4}) == 0.0);
  CHECK(hypervolume({{0, 0, 0}}, {2, 3, 4}) == 24.0);
  // Three unit corners cut from a cube of side 2: each point dominates 1 x 2 x 2 = 4; pairs share 2, all 1.
  CHECK(hypervolume({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {2, 2, 2}) == 7.0);
  CHECK_THROWS(hypervolume({{1, 2}}, {1, 2, 3}));
}

TEST_CASE("the Sobol sequence starts as published, shifted as a whole", "[optim][published]") {
  const auto points = sobol_points(2, 8, 3);
  // Differences to the first point, modulo 1, are the unshifted sequence.
  const std::vector<std::vector<double>> known{{0, 0}, {0.5, 0.5}, {0.75, 0.25}, {0.25, 0.75}};
  for (std::size_t i = 0; i < known.size(); ++i)
    for (std::size_t j = 0; j < 2; ++j) {
      double d = points[i][j] - points[0][j];
      d -= std::floor(d + 1e-12);
      CHECK(std::abs(d - known[i][j]) < 1e-12);
    }
}
