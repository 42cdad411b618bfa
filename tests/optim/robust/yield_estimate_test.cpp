// SPDX-License-Identifier: Apache-2.0
#include "torque_problem.hpp"

#include <catch2/catch.hpp>

#include <twum/optim/random.hpp>
#include <twum/optim/robust.hpp>
#include <twum/optim/yield_estimate.hpp>

#include <cmath>

using namespace twum::optim;
using twum::test::robust_case;

TEST_CASE("the interval of a yield is that of Clopper and Pearson (U5.2)", "[optim][robust]") {
  const struct {
    const char* name;
    std::uint64_t good, products;
  } cases[] = {{"C12 9950/10000", 9950, 10000},
               {"C12 10000/10000", 10000, 10000},
               {"C12 99905/100000", 99905, 100000}};
  for (const auto& c : cases) {
    const YieldEstimate estimate = yield_estimate(c.good, c.products);
    // The table holds twelve digits.
    CHECK(estimate.low == Approx(robust_case(c.name, "low")).epsilon(1e-11));
    CHECK(estimate.high == Approx(robust_case(c.name, "high")).epsilon(1e-11));
  }
  CHECK(yield_estimate(0, 1000).low == 0.0);
  CHECK(yield_estimate(1000, 1000).high == 1.0);
}

TEST_CASE("the verdict on a yield follows from the ends of its interval (U5.3)",
          "[optim][robust]") {
  const YieldEstimate estimate = yield_estimate(9950, 10000);  // 99.34 % to 99.63 %
  CHECK(verdict_on(estimate, 0.9934) == YieldVerdict::holds);
  CHECK(verdict_on(estimate, 0.995) == YieldVerdict::not_distinguishable);
  CHECK(verdict_on(estimate, 0.9964) == YieldVerdict::broken);
}

TEST_CASE("the risk aimed at with weighted products leaves a twentieth for the interval (U5.6)",
          "[optim][robust]") {
  for (const double risk : {1e-9, 1e-6, 9e-5})
    CHECK(risk_to_aim_at_weighted(risk) * 1.05 == Approx(risk).epsilon(1e-15));
}

TEST_CASE("the risk aimed at leaves room for the interval (U5.1, U5.4)", "[optim][robust]") {
  for (const double risk : {0.1, 0.01, 1e-3}) {
    const std::uint64_t products = products_for(risk);
    const double aimed = risk_to_aim_at(risk, products);
    CHECK(aimed + 3.24 * std::sqrt(aimed / static_cast<double>(products)) ==
          Approx(risk).epsilon(1e-12));
    // The failing share is then known within 10 % at 95 %: 1.96 / sqrt(products risk) <= 0.1.
    CHECK(1.96 / std::sqrt(static_cast<double>(products) * risk) <= 0.1);
  }
}

TEST_CASE("the interval covers the true yield in 95 of 100 samples", "[optim][robust]") {
  const double truth = robust_case("C1", "P_ge_0p7");
  const double median =
      std::log(0.2 * 160 * 26.5e-3) - 0.5 * std::log(1.01) - 0.5 * std::log1p(9e-4);
  const double sigma = std::sqrt(std::log(1.01) + std::log1p(9e-4));
  int covered = 0;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    Random random(seed, 1, 0);
    std::uint64_t good = 0;
    for (int i = 0; i < 1000; ++i) {  // Box and Muller: no quantile function of ours
      const double r = std::sqrt(-2 * std::log(1 - random.uniform()));
      const double z = r * std::cos(2 * 3.14159265358979 * random.uniform());
      good += median + sigma * z >= std::log(0.7) ? 1 : 0;
    }
    const YieldEstimate estimate = yield_estimate(good, 1000);
    covered += estimate.low <= truth && truth <= estimate.high ? 1 : 0;
  }
  // At least 95 % by construction; of 1,000 samples 95 % +- 3 x 0.7 %, and no more than the few per cent by which the
  // interval of a discrete count is too wide.
  CHECK(covered >= 935);
  CHECK(covered <= 985);
}

TEST_CASE("failing products alone tell what a tighter tolerance gains (U6.6)", "[optim][robust]") {
  // One limit 0.6 Z1 + 0.8 Z2 <= 2: the yield Phi(2 / |c|), whose change by 1 % less of c_k is 0.01 phi(2) 2 c_k^2.
  const RobustProblem problem = twum::test::linear_problem({{0.6, 0.8}}, {1.0}, 0.97);
  const Verification seen = verify_design(problem, std::vector{2.0}, 100'000, {}, 7);
  REQUIRE(seen.tighter.size() == 2);
  const double density = std::exp(-2.0) / std::sqrt(2 * 3.14159265358979);
  const double direction[] = {0.6, 0.8};
  for (std::size_t k = 0; k < 2; ++k) {
    const SampledMean gain = seen.tighter[k];
    const double exact = 0.01 * density * 2 * direction[k] * direction[k];
    CHECK(std::abs(gain.value - exact) <= 4 * gain.error);
    // Of 100,000 products 2,275 fail, each with a score of some hundredths.
    CHECK(gain.error < 0.1 * exact);
  }
  RobustProblem uniform = problem;
  uniform.inputs[0].law = Law::uniform;
  CHECK(std::isnan(verify_design(uniform, std::vector{2.0}, 1000, {}, 7).tighter[0].value));
}

TEST_CASE("a sample ends where its yields are known to the width that is asked",
          "[optim][robust]") {
  // One limit 0.6 Z1 + 0.8 Z2 <= 3 fails in 0.135 % of the products: the interval of 3,125 is 0.3 % wide. That of a risk of 2.5 % is
  // 0.19 % wide with 100,000 products, and 0.27 % with half as many.
  const RobustProblem problem = twum::test::linear_problem({{0.6, 0.8}}, {1.0}, 0.97);
  const auto made = [&](double x, double width) {
    return verify_design(problem, std::vector{x}, 100'000, {}, 7, width).yields[0].products;
  };
  CHECK(made(3.0, 0.01) == 3125);
  CHECK(made(1.96, 0.0021) == 100'000);
  CHECK(made(3.0, 0.0) == 100'000);
  RobustProblem statistic = problem;  // whose value needs all of them
  statistic.statistics = {{"mean", Statistic::mean, 0}};
  CHECK(verify_design(statistic, std::vector{3.0}, 100'000, {}, 7, 0.01).yields[0].products ==
        100'000);
}
