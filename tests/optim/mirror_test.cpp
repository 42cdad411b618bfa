// SPDX-License-Identifier: Apache-2.0
// To maximize is to minimize the negative. Nothing but signs differs, which are exact in floating point,
// so the mirror image of an answer has to agree with it to the last bit.
#include "optim/bank/dual_problem.hpp"

#include <twum/base/error.hpp>
#include <twum/optim/hypervolume.hpp>
#include <twum/optim/pareto.hpp>
#include <twum/optim/random.hpp>
#include <twum/optim/solve.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace twum;
using namespace twum::optim;
using Catch::Matchers::Contains;

namespace {

using D = Dual<double, 2>;

// Squared distances from (0, 0), (1, 0) and, with three objectives, (0.3, 1), in different units and
// with x + y >= 0.5.
Problem distances(std::size_t objectives) {
  Problem p;
  p.variables = test::box(2, -2.0, 2.0, {1.0, 1.5});
  for (std::size_t k = 0; k < objectives; ++k) p.objectives.push_back({test::numbered('f', k)});
  p.constraints = {{"line", 0.5}};
  p.evaluate = test::dual_evaluator<2>(p.responses(), [objectives](const D* x, D* r) {
    constexpr double kX[] = {0.0, 1.0, 0.3}, kY[] = {0.0, 0.0, 1.0}, kUnit[] = {1.0, 100.0, 0.1};
    for (std::size_t k = 0; k < objectives; ++k) {
      const D dx = x[0] - kX[k], dy = x[1] - kY[k];
      r[k] = kUnit[k] * (dx * dx + dy * dy);
    }
    r[objectives] = x[0] + x[1];
  });
  return p;
}

using Signs = std::vector<double>;  // -1: this objective is turned into one to maximize

Problem mirrored(Problem p, const Signs& signs) {
  for (std::size_t k = 0; k < signs.size(); ++k)
    if (signs[k] < 0.0) p.objectives[k].sense = Sense::maximize;
  p.evaluate = [plain = p.evaluate, signs](std::span<const double> x, bool gradient) {
    Evaluation e = plain(x, gradient);
    for (std::size_t k = 0; k < signs.size(); ++k) {
      e.values[k] *= signs[k];
      for (std::size_t j = 0; j < x.size(); ++j) e.jacobian[x.size() * k + j] *= signs[k];
    }
    return e;
  };
  return p;
}

std::vector<double> turned(std::vector<double> values, const Signs& signs) {
  for (std::size_t k = 0; k < signs.size(); ++k) values[k] *= signs[k];
  return values;
}

void check_mirrored(const Front& image, const Front& plain, const Signs& signs) {
  CAPTURE(signs);
  CHECK(image.outcome == plain.outcome);
  CHECK(image.reference == turned(plain.reference, signs));
  CHECK(image.hypervolume == plain.hypervolume);
  CHECK(image.counters.evaluations == plain.counters.evaluations);
  REQUIRE(image.points.size() == plain.points.size());
  for (std::size_t i = 0; i < plain.points.size(); ++i) {
    CHECK(image.points[i].design == plain.points[i].design);
    CHECK(image.points[i].evaluation.values == turned(plain.points[i].evaluation.values, signs));
    CHECK(image.points[i].certificate.passed == plain.points[i].certificate.passed);
    CHECK(image.points[i].certificate.prices == plain.points[i].certificate.prices);
  }
}

}  // namespace

TEST_CASE("a front of maximized objectives is the mirror image of the minimized one",
          "[optim][pareto][symmetry]") {
  const std::vector<double> reference =
      GENERATE(std::vector<double>{}, std::vector<double>{2, 150});
  ParetoOptions options;
  options.points = 12;
  options.reference = reference;
  const Front plain = pareto_front(distances(2), options);
  REQUIRE(plain.outcome == Outcome::optimal);
  CHECK(plain.points.size() == 12);
  if (!reference.empty()) CHECK(plain.reference == reference);
  for (const Signs& signs : {Signs{-1, 1}, Signs{1, -1}, Signs{-1, -1}}) {
    if (!reference.empty()) options.reference = turned(reference, signs);
    check_mirrored(pareto_front(mirrored(distances(2), signs), options), plain, signs);
  }
}

TEST_CASE("so is a front of three objectives", "[optim][pareto][symmetry]") {
  ParetoOptions options;
  options.points = 6;
  const Front plain = pareto_front(distances(3), options);
  REQUIRE(plain.points.size() == 6);
  for (const Signs& signs : {Signs{1, -1, 1}, Signs{-1, 1, -1}})
    check_mirrored(pareto_front(mirrored(distances(3), signs), options), plain, signs);
}

TEST_CASE("and what a population finds", "[optim][pareto][symmetry]") {
  Nsga2Options options;
  options.population = 12;
  options.generations = 8;
  const Front plain = nsga2(distances(2), options);
  REQUIRE_FALSE(plain.points.empty());
  for (const Signs& signs : {Signs{-1, 1}, Signs{-1, -1}})
    check_mirrored(nsga2(mirrored(distances(2), signs), options), plain, signs);
}

TEST_CASE("a front whose points agree in an objective is measured from a tenth of a unit beyond",
          "[optim][pareto][closed_form]") {
  // Both objectives are least at the same design: one point, without a span.
  const double sign = GENERATE(1.0, -1.0);
  Problem p = distances(2);
  p.constraints.clear();
  p.evaluate = test::dual_evaluator<2>(2, [](const D* x, D* r) {
    r[0] = 3.0 + x[0] * x[0] + x[1] * x[1];
    r[1] = 5.0 + 2.0 * x[0] * x[0] + x[1] * x[1];
  });
  const Front front = pareto_front(mirrored(p, {sign, 1.0}));
  REQUIRE(front.points.size() == 1);
  const auto& values = front.points[0].evaluation.values;
  // Rounding of the sum alone.
  CHECK(front.reference[0] == Approx(values[0] + sign * 0.1).epsilon(1e-14));
  CHECK(front.reference[1] == Approx(values[1] + 0.1).epsilon(1e-14));
}

TEST_CASE("a reference of another size than the objectives is refused", "[optim][pareto][error]") {
  ParetoOptions options;
  options.reference = {1.0, 2.0, 3.0};
  const std::string text = "the reference point has 3 values for 2 objectives";
  CHECK_THROWS_WITH(pareto_front(distances(2), options), Contains(text));
  Nsga2Options population;
  population.reference = options.reference;
  CHECK_THROWS_WITH(nsga2(distances(2), population), Contains(text));
}

TEST_CASE("every stage of a maximization reports the mirror image of its minimum",
          "[optim][symmetry]") {
  const std::string solver = GENERATE("auto", "nlopt:slsqp", "nlopt:cobyla");
  SolveOptions options;
  options.solver = solver;
  const Result least = solve(distances(1), options);
  const Result most = solve(mirrored(distances(1), {-1.0}), options);
  CAPTURE(solver);
  REQUIRE(least.outcome == Outcome::optimal);
  REQUIRE(most.outcome == Outcome::optimal);
  CHECK(most.design == least.design);
  CHECK(most.evaluation.values[0] == -least.evaluation.values[0]);
  REQUIRE_FALSE(least.stages.empty());
  REQUIRE(most.stages.size() == least.stages.size());
  double best = kInfinity;
  for (std::size_t i = 0; i < least.stages.size(); ++i) {
    CHECK(most.stages[i].objective == -least.stages[i].objective);
    if (least.stages[i].feasible) best = std::min(best, least.stages[i].objective);
  }
  // The best stage's answer is the answer; it has been through its scale and back.
  CHECK(best == Approx(least.evaluation.values[0]).epsilon(1e-14));
}

TEST_CASE("points chosen by hypervolume are those that trying every choice finds",
          "[optim][pareto][brute_force]") {
  constexpr std::size_t kPoints = 9, kCount = 4;
  for (std::uint64_t s = 0; s < 20; ++s) {
    Random random(7, 1, s);
    std::vector<std::vector<double>> front;
    double x = 0.0, y = 1.0;
    for (std::size_t i = 0; i < kPoints; ++i)
      front.push_back({x += random.uniform(), y -= random.uniform()});
    const std::vector<double> reference{x + 0.5, 1.5};
    const auto volume = [&](const std::vector<std::size_t>& chosen) {
      std::vector<std::vector<double>> points;
      for (const std::size_t i : chosen) points.push_back(front[i]);
      return hypervolume(points, reference);
    };
    double best = 0.0;
    for (std::size_t a = 1; a < kPoints - 1; ++a)
      for (std::size_t b = a + 1; b < kPoints - 1; ++b)
        best = std::max(best, volume({0, a, b, kPoints - 1}));
    const auto subset = best_subset(front, kCount, reference);
    REQUIRE(subset.size() == kCount);
    CHECK(subset.front() == 0);
    CHECK(subset.back() == kPoints - 1);
    CHECK(volume(subset) == Approx(best).epsilon(1e-14));  // sums of the same areas

    std::vector<std::size_t> one_by_one;
    while (one_by_one.size() < kPoints) {
      std::size_t next = 0;
      double most = -1.0;
      for (std::size_t i = 0; i < kPoints; ++i) {
        auto with = one_by_one;
        with.push_back(i);
        if (volume(with) <= most) continue;
        most = volume(with);
        next = i;
      }
      one_by_one.push_back(next);
    }
    for (std::size_t count = 1; count <= kPoints; ++count) {
      std::vector<std::size_t> first(one_by_one.begin(),
                                     one_by_one.begin() + static_cast<std::ptrdiff_t>(count));
      std::sort(first.begin(), first.end());
      CHECK(greedy_subset(front, count, reference) == first);
    }
    CHECK(greedy_subset(front, 2 * kPoints, reference).size() == kPoints);
  }
}

TEST_CASE("points at one level, or on the reference, count once or not at all",
          "[optim][pareto][closed_form]") {
  // In the plane 2 x 2 less the unit square that neither has, times the height of 1.
  CHECK(hypervolume({{0, 1, 1}, {1, 0, 1}}, {2, 2, 2}) == 3.0);
  CHECK(hypervolume({{1, 0, 1}, {0, 1, 1}, {0, 1, 1}}, {2, 2, 2}) == 3.0);
  CHECK(hypervolume({{4, 0}, {0, 4}}, {4, 4}) == 0.0);
  CHECK(hypervolume({{1, 1}, {2, 1}}, {4, 4}) == 9.0);
}
