// SPDX-License-Identifier: Apache-2.0
#include "torque_problem.hpp"

#include "robust/moments.hpp"
#include "robust/round.hpp"

#include <catch2/catch.hpp>

#include <twum/optim/solve.hpp>

#include <cmath>

using namespace twum::optim;
using twum::test::response_problem;
using twum::test::robust_case;
using twum::test::torque_problem;

namespace {

Moment moment_of(const RobustProblem& problem, Statistic kind, double x) {
  return moment(problem, {"statistic", kind}, std::vector<double>{x}, moment_sample(problem, 1));
}

}  // namespace

TEST_CASE("mean and spread over the fixed sample are those of the law (U2.1, U2.2)",
          "[optim][robust]") {
  // Five standard errors of 256 independent products: sd / 16 for a mean, about as much for a standard deviation of laws
  // this near to normal. A Sobol sequence is better.
  const auto torque = torque_problem(Law::lognormal);
  const double spread = robust_case("C1", "sd");
  CHECK(moment_of(torque, Statistic::mean, 160).value ==
        Approx(robust_case("C1", "mean")).margin(5 * spread / 16));
  CHECK(moment_of(torque, Statistic::sd, 160).value == Approx(spread).margin(5 * spread / 16));

  auto curved = response_problem(2, Law::normal, [](std::span<const double> z) {
    return Evaluation{
        {1 + 2 * z[0] + 0.5 * z[1] * z[1] + z[0] * z[1]}, {2 + z[1], z[1] + z[0]}, {}, {}};
  });
  curved.limits = {{"X"}};
  const double sd = robust_case("C13", "sd");
  CHECK(moment_of(curved, Statistic::mean, 0.5).value ==
        Approx(robust_case("C13", "mean")).margin(5 * sd / 16));
  CHECK(moment_of(curved, Statistic::sd, 0.5).value == Approx(sd).margin(5 * sd / 16));
}

TEST_CASE("gradients of mean and spread agree with differences (U2.1, U2.2)", "[optim][robust]") {
  const auto torque = torque_problem(Law::lognormal);
  for (const Statistic kind : {Statistic::mean, Statistic::sd}) {
    const double h = 1e-3;
    const double slope =
        (moment_of(torque, kind, 160 + h).value - moment_of(torque, kind, 160 - h).value) / (2 * h);
    // The torque is proportional to the preload: no third derivative, rounding eps / h = 1e-13 of 1e-3.
    CHECK(moment_of(torque, kind, 160).by_design[0] == Approx(slope).epsilon(1e-7));
  }
}

TEST_CASE("a mean over too many products without an answer is refused", "[optim][robust]") {
  auto problem = torque_problem(Law::lognormal);
  problem.built = [built = problem.built](std::span<const double> p,
                                          std::optional<std::size_t> only, bool gradient) {
    if (p[1] > 0.23) return Evaluation{{}, {}, {}, "no-answer"};  // about one in fourteen
    return built(p, only, gradient);
  };
  CHECK(moment_of(problem, Statistic::mean, 160).failure == "no-answer");
}

TEST_CASE("a limit on a quantile, a mean or a spread holds at the optimum (U2.1, U2.2, U2.3)",
          "[optim][robust]") {
  // Torque is proportional to preload, so the largest preload is 160 N times limit over statistic at 160 N.
  const auto largest = [](Statistic kind, double probability, double upper) {
    RobustProblem problem = torque_problem(Law::lognormal);
    problem.statistics = {{"statistic", kind, 0, probability, -kInfinity, upper}};
    const RobustResult found = solve_robust(problem);
    CHECK(found.outcome == Outcome::optimal);
    return found.design[0];
  };
  // The quantile is corrected by a sample: 2 % of an index of spread 0.1, see the weighted quantile.
  CHECK(largest(Statistic::quantile, 0.95, 1.2) ==
        Approx(160 * 1.2 / robust_case("C1", "q95")).epsilon(2e-3));
  CHECK(largest(Statistic::mean, 0.5, 1.0) ==
        Approx(160 / robust_case("C1", "mean")).epsilon(5 * 0.104 / 16));
  CHECK(largest(Statistic::sd, 0.5, 0.1) ==
        Approx(160 * 0.1 / robust_case("C1", "sd")).epsilon(5.0 / 16));
}
