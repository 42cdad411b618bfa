// SPDX-License-Identifier: Apache-2.0
#include "optim/bank/fronts.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <twum/optim/hypervolume.hpp>
#include <twum/optim/pareto.hpp>

using namespace twum;
using namespace twum::optim;

namespace {

ParetoOptions options_for(const test::KnownFront& known) {
  ParetoOptions options;
  options.reference = known.reference;
  options.solve.budget.evaluations = 200000;
  if (known.many_local_fronts) options.population_evaluations = 15000;
  return options;
}

std::size_t certified(const Front& front) {
  std::size_t count = 0;
  for (const auto& p : front.points) count += p.certificate.passed ? 1U : 0U;
  return count;
}

}  // namespace

TEST_CASE("100 points by gradients reach 99.9 percent of what any 100 points can have",
          "[optim][pareto][manufactured]") {
  for (const auto& known : test::known_fronts(1000)) {
    const Front front = pareto_front(known.problem, options_for(known));
    const double best = test::best_hypervolume(known.front, 100, known.reference);
    WARN(known.name << ": hypervolume " << front.hypervolume << ", best of 100 " << best << ", ratio "
                    << front.hypervolume / best << ", points " << front.points.size() << ", certified "
                    << certified(front) << ", evaluations " << front.counters.evaluations << ", s " << front.seconds);
    CHECK(front.points.size() <= 100);
    CHECK(front.hypervolume >= 0.999 * best);
  }
}

TEST_CASE("three objectives: the fronts of DTLZ1 and DTLZ2", "[optim][pareto][manufactured]") {
  ParetoOptions options;
  options.solve.budget.evaluations = 200000;
  options.points = 100;
  options.reference = {0.5, 0.5, 0.5};
  const Front plane = pareto_front(test::dtlz1(), options);
  options.reference = {1.1, 1.1, 1.1};
  const Front sphere = pareto_front(test::dtlz2(), options);
  WARN(plane.hypervolume << " " << plane.points.size() << " " << certified(plane) << " " << plane.counters.evaluations);
  WARN(sphere.hypervolume << " " << sphere.points.size() << " " << certified(sphere) << " " << sphere.counters.evaluations);
  CHECK(plane.hypervolume >= 0.098);
  CHECK(sphere.hypervolume >= 0.750);
}
