// SPDX-License-Identifier: Apache-2.0
// ring-60 under tolerances against the figures of two other programs (docs/theory/robust-design.md).
#include "search_support.hpp"

#include <catch2/catch.hpp>

#include <twum/optim/robust.hpp>
#include <twum/optim/solve.hpp>
#include <twum/studies/robust_question.hpp>

#include <cmath>

using namespace twum;
using namespace twum::test;

namespace {

RobustQuestion ring_question(double yield = 0.99) {
  const StudyFile file = example_study("robust-ring-60.yaml");
  const auto& asked = std::get<OptimizeStudy>(file.asked);
  RobustQuestion question{
      {file.motor.design, asked.variables, {asked.objective}, asked.constraints},
      asked.tolerances,
      asked.statistics};
  question.statistics.front().lower = yield;
  return question;
}

optim::RobustResult by_form(const RobustQuestion& question,
                            const std::vector<std::vector<double>>& starts = {}) {
  optim::RobustOptions options;
  options.starts = starts;
  options.draws = starts.empty() ? 3 : 0;
  options.solve.jobs = 2;
  return optim::solve_form(robust_problem(question), options);
}

double objective(const optim::RobustResult& found) { return found.last.evaluation.values.front(); }

}  // namespace

TEST_CASE("FORM alone gives ring-60 the figures of two other programs (U3.1, U6.2, U6.4)",
          "[studies][robust]") {
  const RobustQuestion question = ring_question();
  const optim::RobustResult found = by_form(question);
  CHECK(found.last.certificate.passed);
  // 6.8104 W there, to the digits given; the other valley has 6.7970 W.
  CHECK(objective(found) == Approx(6.8104).margin(1e-3));
  const double told[] = {0.99e-3, 2.02e-3, 0.29e-3, 0.44e-3,
                         43.72e-3};  // gain per 1 % [W], by tolerance as in the study
  for (std::size_t k = 0; k < 5; ++k) {
    CAPTURE(found.prices[k].input);
    // Half of the last digit, and the share of the risk that this search leaves to limits that hardly fail (0.1 %).
    CHECK(found.prices[k].gain_per_percent_tighter ==
          Approx(told[k]).margin(0.006e-3).epsilon(2e-3));
    const auto with_spread = [&](double factor) {
      RobustQuestion other = question;
      other.tolerances[k].sd->amount *= factor;
      return objective(by_form(other, {found.design}));
    };
    // Central difference of solving again with a spread 0.1 % smaller and larger. One of 0.5 % is off by 3 % (third derivative,
    // as the specification has it), this one by a twenty-fifth of that.
    const double gain = 5 * (with_spread(0.999) - with_spread(1.001));
    CHECK(found.prices[k].gain_per_percent_tighter == Approx(gain).epsilon(2e-3));
  }
}

TEST_CASE("with 2 % on the amplitude FORM reaches 99.9 %", "[studies][robust]") {
  RobustQuestion question = ring_question(0.999);
  question.tolerances.back().sd->amount = 0.02;
  // 7.397 W by two other programs, three digits.
  CHECK(objective(by_form(question)) == Approx(7.397).margin(2e-3));
}

TEST_CASE("ring-60 at 99 % before aiming higher, for two seeds (U4.5)", "[studies][robust]") {
  const optim::RobustProblem problem = robust_problem(ring_question());
  for (const std::uint64_t seed : {1U, 2U}) {
    optim::RobustOptions options;
    options.back_off = false;
    options.price_yields = false;
    options.solve.seed = seed;
    options.solve.jobs = 2;
    const optim::RobustResult found = optim::solve_robust(problem, options);
    // 6.867 W there; 1 % of the risk, what the sample leaves, is worth 0.0065 W, and the margin is three of them.
    CHECK(objective(found) == Approx(6.867).margin(0.02));
    CHECK(found.verdict != optim::YieldVerdict::broken);
    CHECK(found.last.certificate.passed);
  }
}

TEST_CASE("99.9 % of ring-60 cannot be reached, and the largest yield is told (U3.6)",
          "[studies][robust]") {
  optim::RobustOptions options;
  options.solve.jobs = 2;
  options.draws = 1;
  options.price_yields = false;
  const optim::RobustResult found =
      optim::solve_robust(robust_problem(ring_question(0.999)), options);
  CHECK(found.outcome == optim::Outcome::infeasible);
  // 99.494 +- 0.008 % there.
  CHECK(found.largest_yield == Approx(0.99494).margin(0.0003));
  CHECK(found.verification.yields[0].low <= found.largest_yield);
  CHECK(found.verification.yields[0].high >= found.largest_yield);
}
