// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include <twum/base/error.hpp>
#include <twum/optim/correlation.hpp>
#include <twum/optim/robust.hpp>

#include <cmath>
#include <numbers>
#include <random>

using namespace twum::optim;

namespace {

double below(double z) { return std::erfc(-z / std::numbers::sqrt2) / 2; }
double density(double z) { return std::exp(-z * z / 2) / std::sqrt(2 * std::numbers::pi); }

const std::vector<CorrelatedPair> kThree{{0, 1, 0.6}, {2, 1, -0.3}, {0, 2, 0.2}};

// x + s_1 y_1 + s_2 y_2 >= 1, the least x: a normal sum with the variance s_1^2 + s_2^2 + 2 rho s_1 s_2.
constexpr double kFirst = 0.3, kSecond = 0.2;

RobustProblem normal_sum(double rho, double yield) {
  RobustProblem problem;
  problem.design.variables = {{"x", 0, 5, 2}};
  problem.design.objectives = {{"x", Sense::minimize}};
  problem.design.evaluate = [](std::span<const double> x, bool gradient) {
    Evaluation answer;
    answer.values = {x[0]};
    if (gradient) answer.jacobian = {1};
    return answer;
  };
  problem.inputs = {{"a", Law::normal, kFirst, 0, false, 0}, {"b", Law::normal, kSecond, 0, false}};
  const std::vector<CorrelatedPair> pairs{{0, 1, rho}};
  problem.correlation = {2, pairs};
  problem.limits = {{"sum", 1}};
  problem.yields = {{"yield", {0}, yield}};
  problem.built = [](std::span<const double> built, std::optional<std::size_t>, bool gradient) {
    Evaluation answer;
    answer.values = {built[0] + built[1]};
    if (gradient) answer.jacobian = {1, 1};
    return answer;
  };
  return problem;
}

double variance(double rho) {
  return kFirst * kFirst + kSecond * kSecond + 2 * rho * kFirst * kSecond;
}

}  // namespace

TEST_CASE(
    "correlated numbers have the wanted covariance, and slopes are those of the transpose (U1.9)",
    "[optim][robust][correlation]") {
  const Correlation correlation(3, kThree);
  // E y y^T = L L^T: the sum over the unit vectors of their images.
  double covariance[3][3] = {};
  for (std::size_t k = 0; k < 3; ++k) {
    std::vector<double> unit(3, 0.0);
    unit[k] = 1;
    const std::vector<double> y = correlation.correlated(unit);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) covariance[i][j] += y[i] * y[j];
  }
  for (std::size_t i = 0; i < 3; ++i) CHECK(covariance[i][i] == Approx(1).epsilon(1e-14));
  for (const CorrelatedPair& pair : kThree)
    CHECK(covariance[pair.a][pair.b] == Approx(pair.coefficient).epsilon(1e-14));
  const std::vector<double> z{0.3, -1.2, 0.7}, g{2, 0.5, -1};
  const std::vector<double> y = correlation.correlated(z), slopes = correlation.slopes(g);
  CHECK(g[0] * y[0] + g[1] * y[1] + g[2] * y[2] ==
        Approx(slopes[0] * z[0] + slopes[1] * z[1] + slopes[2] * z[2]).epsilon(1e-14));
  // (U1.10): y^T R^-1 y = |z|^2.
  const std::vector<double> parts = correlation.parts(z);
  CHECK(parts[0] + parts[1] + parts[2] == Approx(0.09 + 1.44 + 0.49).epsilon(1e-14));
  CHECK(Correlation().independent());
  for (std::size_t k = 0; k < 3; ++k) CHECK(Correlation().parts(z)[k] == z[k] * z[k]);
}

TEST_CASE("a matrix that is none is refused with the pair that makes it so",
          "[optim][robust][correlation]") {
  using Pairs = std::vector<CorrelatedPair>;
  const auto wrong = [](const Pairs& pairs) { return Correlation::wrong_pair(3, pairs); };
  CHECK_FALSE(wrong(kThree));
  // With 0.9 and 0.9 the third lies between 0.62 and 1: 0.81 -+ 0.19.
  CHECK_FALSE(wrong({{0, 1, 0.9}, {1, 2, 0.9}, {0, 2, 0.63}}));
  CHECK(wrong({{0, 1, 0.9}, {1, 2, 0.9}, {0, 2, 0.61}}) == 2);
  CHECK(wrong({{0, 1, 0.9}, {1, 2, 0.9}}) == 1);  // the third is 0
  CHECK(wrong({{0, 1, 0.9}, {1, 0, 0.9}}) == 1);
  CHECK(wrong({{1, 1, 0.5}}) == 0);
  CHECK(wrong({{0, 3, 0.5}}) == 0);
  CHECK(wrong({{0, 1, 1.0}}) == 0);
  const Pairs contradiction{{0, 1, 0.9}, {1, 2, 0.9}, {0, 2, -0.9}};
  CHECK_THROWS_AS(Correlation(3, contradiction), twum::InputError);
}

TEST_CASE("the optimum of a sum of correlated normal inputs is that of the sum (U1.9, U1.10, U6.1)",
          "[optim][robust][correlation]") {
  for (const double rho : {-0.7, 0.0, 0.7}) {
    CAPTURE(rho);
    const double beta = 3.090232306167813;  // Phi^-1(0.999), a textbook number
    const RobustResult found = solve_form(normal_sum(rho, 0.999));
    // The search stops where the scaled limit holds to 1e-8.
    CHECK(found.design[0] == Approx(1 + beta * std::sqrt(variance(rho))).epsilon(1e-7));
    REQUIRE(found.risks.size() == 1);
    // What an input has of the variance: s_1^2 + rho s_1 s_2.
    const double first = (kFirst * kFirst + rho * kFirst * kSecond) / variance(rho);
    CHECK(found.risks[0].importance[0] == Approx(first).epsilon(1e-6));
    CHECK(found.risks[0].importance[1] == Approx(1 - first).epsilon(1e-6));
    // x = 1 + beta sqrt(variance): d x / d ln s_1 = beta (s_1^2 + rho s_1 s_2) / sqrt(variance).
    CHECK(found.prices[0].gain_per_percent_tighter ==
          Approx(0.01 * beta * first * std::sqrt(variance(rho))).epsilon(1e-5));
  }
}

TEST_CASE(
    "a sample of correlated inputs has the share of the sum, and what a tighter spread is worth "
    "(U6.6)",
    "[optim][robust][correlation]") {
  constexpr double kRho = 0.7;
  constexpr std::uint64_t kProducts = 100000;
  const RobustProblem problem = normal_sum(kRho, 0.99);
  const double x = 1 + 2 * std::sqrt(variance(kRho));
  const std::vector<double> design{x};
  const Verification found = verify_design(problem, design, kProducts, {}, 5);
  const double share = below(2);
  const auto n = static_cast<double>(kProducts);
  CHECK(found.yields[0].value == Approx(share).margin(5 * std::sqrt(share * (1 - share) / n)));
  // Y = Phi(beta), beta = 2: 1 % less of s_1 gives 0.01 phi(beta) beta (s_1^2 + rho s_1 s_2) / variance.
  const double first = (kFirst * kFirst + kRho * kFirst * kSecond) / variance(kRho);
  REQUIRE(found.tighter.size() == 2);
  CHECK(found.tighter[0].value ==
        Approx(0.01 * density(2) * 2 * first).margin(5 * found.tighter[0].error));
  CHECK(found.tighter[1].value ==
        Approx(0.01 * density(2) * 2 * (1 - first)).margin(5 * found.tighter[1].error));
}

TEST_CASE("a product of correlated lognormal inputs keeps its limit as the logarithm says (U3.2)",
          "[optim][robust][correlation]") {
  // P = x b: ln P is normal with mean ln x - (v_1 + v_2) / 2 and variance v_1 + v_2 + 2 rho sqrt(v_1 v_2).
  for (const double rho : {-0.5, 0.8}) {
    CAPTURE(rho);
    RobustProblem problem = normal_sum(rho, 0.99);
    problem.inputs = {{"a", Law::lognormal, 0.3, 0, true, 0},
                      {"b", Law::lognormal, 0.2, 0, true, {}, 1.0}};
    problem.built = [](std::span<const double> built, std::optional<std::size_t>, bool gradient) {
      Evaluation answer;
      answer.values = {built[0] * built[1]};
      if (gradient) answer.jacobian = {built[1], built[0]};
      return answer;
    };
    const double a = std::log1p(0.09), b = std::log1p(0.04);
    const double sd = std::sqrt(a + b + 2 * rho * std::sqrt(a * b));
    const double x = std::exp((a + b) / 2 + 2.32634787404 * sd);
    CHECK(solve_form(problem).design[0] == Approx(x).epsilon(1e-6));
  }
}
