// SPDX-License-Identifier: Apache-2.0
#include "torque_problem.hpp"

#include "robust/round.hpp"

#include <catch2/catch.hpp>

#include <twum/optim/solve.hpp>

#include <cmath>

using namespace twum::optim;
using twum::test::linear_problem;
using twum::test::robust_case;
using twum::test::torque_problem;

namespace {

// Largest preload of which 99 % keep the holding torque below 1 N.m, C8.
RobustProblem largest_preload() {
  RobustProblem problem = torque_problem(Law::lognormal);
  problem.limits[0].upper = 1.0;
  problem.yields = {{"yield", {0}, 0.99}};
  return problem;
}

double price(const RobustResult& result, std::size_t input, double spread) {
  return -result.prices[input].gain_per_percent_tighter / (0.01 * spread);
}

}  // namespace

TEST_CASE("FORM finds the optimum of one limit that is linear in the logarithm (U1.8, U3.1, U6.2)",
          "[optim][robust]") {
  const RobustResult found = solve_form(largest_preload());
  CHECK(found.last.certificate.passed);
  // The search stops where the scaled limit holds to 1e-8.
  CHECK(found.design[0] == Approx(robust_case("C8", "F")).epsilon(1e-7));
  // The certificate's multipliers are good to its stationarity, 1e-6.
  CHECK(price(found, 0, 0.1) == Approx(robust_case("C8b", "dmu")).epsilon(1e-6));
  CHECK(price(found, 1, 0.03) == Approx(robust_case("C8b", "dF")).epsilon(1e-6));
  REQUIRE(found.risks.size() == 1);
  // One limit spends the whole risk: beta = Phi^-1(0.99), a textbook number.
  CHECK(found.risks[0].beta == Approx(2.32634787404).epsilon(1e-7));
}

TEST_CASE("without tolerances the optimum sits on its limit", "[optim][robust]") {
  // 1 N.m / (mu r), C8; the search ends where the scaled limit holds to 1e-8.
  CHECK(solve(nominal_problem(largest_preload())).design[0] ==
        Approx(robust_case("C8", "nominal")).epsilon(1e-7));
}

TEST_CASE("smallest preload of which 99 % and 99.9 % hold 0.8 N.m", "[optim][robust]") {
  RobustProblem problem = torque_problem(Law::lognormal);
  problem.limits[0].lower = 0.8;
  problem.design.objectives[0].sense = Sense::minimize;
  problem.yields = {{"yield", {0}, 0.99}};
  CHECK(solve_form(problem).design[0] == Approx(robust_case("C1b", "F99")).epsilon(1e-7));
  problem.yields[0].at_least = 0.999;
  CHECK(solve_form(problem).design[0] == Approx(robust_case("C1b", "F999")).epsilon(1e-7));
}

TEST_CASE("the preload of largest yield between two ends is their geometric mean (U3.6)",
          "[optim][robust]") {
  RobustProblem problem = torque_problem(Law::lognormal);
  problem.limits[0].lower = 0.75;
  problem.limits[0].upper = 0.95;
  problem.yields = {{"yield", {0}, 0.99}};
  problem.goals = {{RobustGoal::yield}};
  // Both ends are linear in the logarithm and never fail together, so FORM is exact. The yield is flat at its maximum:
  // 1e-6 of stationarity over its curvature leaves 1e-5 of the preload.
  CHECK(solve_form(problem).design[0] == Approx(robust_case("C9", "Fbest")).epsilon(1e-5));
  const RobustResult found = solve_robust(problem);
  CHECK(found.outcome == Outcome::optimal);
  // Fresh products: the interval covers with 95 %, this seed is one of them.
  const YieldEstimate& yield = found.verification.yields[0];
  CHECK(yield.low <= robust_case("C9", "ybest"));
  CHECK(yield.high >= robust_case("C9", "ybest"));
}

TEST_CASE("risk is shared out between correlated limits as the exact optimum has it (U3.1)",
          "[optim][robust]") {
  for (const char* rho : {"0.6", "-0.6", "0.95"}) {
    CAPTURE(rho);
    const double r = std::stod(rho);
    const std::string quantity = std::string("x1, x2, x1+2 x2 at rho=") + rho;
    const RobustProblem problem =
        linear_problem({{1.0, 0.0}, {r, std::sqrt(1 - r * r)}}, {1.0, 2.0}, 0.99);
    const double exact = robust_case("C18", quantity.c_str(), 2);

    Correction known = Correction::none(RobustTerms(problem));
    known.overlaps = {{{0, 1, r}}};
    const RobustRound round(problem, problem.goals, {0.01}, known);
    SolveOptions options;
    options.tolerance = 1e-9;
    options.starts = 1;
    const Result solved = solve(round.problem(), options);
    // Two limits have one overlap, so the joint risk is exact; the table holds ten digits.
    CHECK(solved.design[0] + 2 * solved.design[1] == Approx(exact).epsilon(1e-8));

    RobustOptions sampled;
    sampled.back_off = false;
    const RobustResult found = solve_robust(problem, sampled);
    CHECK(found.last.certificate.passed);
    // What 16,384 products about the worst points leave: 1 % of the risk, which costs 0.01 p / (phi(beta) beta) of an index.
    CHECK(found.design[0] + 2 * found.design[1] == Approx(exact).epsilon(2e-3));
  }
}

TEST_CASE("what a tighter tolerance gains is told at the same design (U6.1, U6.3, U6.5)",
          "[optim][robust]") {
  // The least preload whose yield is that of C1 at 160 N: the design of the table.
  RobustProblem problem = torque_problem(Law::lognormal);
  problem.limits[0].lower = 0.7;
  problem.design.objectives[0].sense = Sense::minimize;
  problem.yields = {{"yield", {0}, robust_case("C1", "P_ge_0p7")}};
  const RobustResult found = solve_form(problem);
  CHECK(found.design[0] == Approx(160.0).epsilon(1e-7));
  // Twelve digits of the yield, 1e-6 of the search.
  CHECK(found.prices[0].yield_per_percent_tighter / (0.01 * 0.1) ==
        Approx(-robust_case("C15", "dP/ds_mu of P(holding_torque >= 0.7 N.m)")).epsilon(1e-6));
  const double friction = std::log(1.01), preload = std::log1p(9e-4);
  // The logarithm is linear in z: shares are those of the variances.
  CHECK(found.risks[0].importance[0] == Approx(friction / (friction + preload)).epsilon(1e-6));
}

TEST_CASE("the price of the yield is the slope of the optimum over it (U6.4)", "[optim][robust]") {
  const auto force = [](double yield) {
    RobustProblem problem = largest_preload();
    problem.yields[0].at_least = yield;
    return solve_form(problem).last.evaluation.values[0];
  };
  // Central difference over 1e-5 of the risk 1e-2: the third derivative leaves 1e-6.
  CHECK(solve_form(largest_preload()).price_of_yield ==
        Approx((force(0.98999) - force(0.99001)) / 2e-5).epsilon(1e-4));
}

TEST_CASE(
    "a corrected optimum holds on fresh products and is the same for any number of threads (U4.5, "
    "U5.3)",
    "[optim][robust]") {
  const RobustProblem problem = largest_preload();
  RobustOptions options;
  const RobustResult one = solve_robust(problem, options);
  CHECK(one.outcome == Outcome::optimal);
  CHECK(one.verdict == YieldVerdict::holds);
  CHECK(one.verification.yields[0].low >= 0.99);
  // The exact yield of the design, by the law of its logarithm, lies above the wanted one.
  const double median = 0.2 * 26.5e-3 * one.design[0] / std::sqrt(1.01 * 1.0009);
  const double exact =
      0.5 * std::erfc(std::log(median) / std::sqrt(2 * (std::log(1.01) + std::log1p(9e-4))));
  CHECK(exact > 0.99);
  CHECK(one.verification.yields[0].low <= exact);
  CHECK(one.verification.yields[0].high >= exact);
  for (const std::size_t threads : {2U, 7U}) {
    options.solve.jobs = threads;
    const RobustResult other = solve_robust(problem, options);
    CHECK(other.design == one.design);
    CHECK(other.verification.values == one.verification.values);
    CHECK(other.counters.evaluations == one.counters.evaluations);
  }
}

TEST_CASE("a yield that cannot be reached is refused with the largest one (U3.6)",
          "[optim][robust]") {
  RobustProblem problem = torque_problem(Law::lognormal);
  problem.limits[0].lower = 0.75;
  problem.limits[0].upper = 0.95;
  problem.yields = {{"yield", {0}, 0.99}};
  const RobustResult found = solve_robust(problem);
  CHECK(found.outcome == Outcome::infeasible);
  CHECK(found.verdict == YieldVerdict::broken);
  // Sampled with 16,384 products about both ends: 1 % of the failing quarter.
  CHECK(found.largest_yield == Approx(robust_case("C9", "ybest")).margin(0.005));
  CHECK(found.design[0] == Approx(robust_case("C9", "Fbest")).epsilon(1e-2));
}

TEST_CASE("limits that cannot fail leave the nominal optimum", "[optim][robust]") {
  RobustProblem problem = torque_problem(Law::uniform);
  problem.limits[0].upper = 10.0;  // at 300 N and both inputs at their worst 1.8 N.m
  problem.yields = {{"yield", {0}, 0.99}};
  RobustOptions options;
  std::uint64_t told = 0, most = 0;
  options.sampled = [&](std::uint64_t made, std::uint64_t of) { told = made, most = of; };
  const RobustResult found = solve_robust(problem, options);
  CHECK(found.outcome == Outcome::optimal);
  CHECK(found.design[0] == 300.0);
  CHECK(found.verification.yields[0].value == 1.0);
  // Nothing is corrected, as no risk holds the goal back, and a 32nd of the products shows it (U5.3a).
  CHECK(found.rounds.empty());
  CHECK(found.verification.yields[0].products == 1250);
  CHECK(told == 1250);
  CHECK(most == 40'000);
  for (const YieldPrice& price : found.prices_of_yields) CHECK(price.objective == 300.0);
  CHECK(found.prices_of_yields.size() == 6);
}

TEST_CASE("products without an answer break every limit and are counted", "[optim][robust]") {
  RobustProblem problem = largest_preload();
  problem.built = [built = problem.built](std::span<const double> p,
                                          std::optional<std::size_t> only, bool gradient) {
    // Friction above three standard deviations has no answer: a share of 1.3e-3.
    if (p[1] > 0.2 * std::exp(3 * std::sqrt(std::log(1.01)) - 0.5 * std::log(1.01)))
      return Evaluation{{}, {}, {}, "no-answer"};
    return built(p, only, gradient);
  };
  const RobustResult found = solve_robust(problem);
  REQUIRE(found.verification.lost.count("no-answer") == 1);
  const auto lost = static_cast<double>(found.verification.lost.at("no-answer"));
  // Binomial, 40,000 x 1.35e-3 = 54 with a standard deviation of 7.3: four of them.
  CHECK(std::abs(lost - 54.0) <= 4 * 7.3);
  CHECK(found.verdict == YieldVerdict::holds);
}

TEST_CASE("a yield above 99.99 % is told from weighted products (U5.5)", "[optim][robust]") {
  // Two independent margins x_j >= Z_j with equal weights: the risk 2 Phi(-x) in each at the optimum, less its square.
  const RobustProblem problem = linear_problem({{1.0, 0.0}, {0.0, 1.0}}, {1.0, 1.0}, 0.999999);
  const RobustResult found = solve_robust(problem);
  CHECK(found.outcome == Outcome::optimal);
  CHECK(found.verification.weighted);
  const YieldEstimate& yield = found.verification.yields[0];
  const auto fails = [](double x) { return 0.5 * std::erfc(x / std::sqrt(2.0)); };
  const double risk = fails(found.design[0]) + fails(found.design[1]);
  CHECK(1 - yield.high <= risk);
  CHECK(1 - yield.low >= risk);
  // 65,536 products about the worst points, of which a third fails: the risk within some per cent, where as many plain ones
  // would have no failure at all.
  CHECK(yield.high - yield.low < 0.1 * risk);
  // Both limits fail as often.
  CHECK(found.risks[0].share == Approx(0.5).epsilon(0.1));
  CHECK(found.design[0] == Approx(found.design[1]).epsilon(0.01));
}
