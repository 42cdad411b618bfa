// SPDX-License-Identifier: Apache-2.0
#include "torque_problem.hpp"

#include "robust/inverse_form.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <random>

using namespace twum::optim;
using twum::test::response_problem;
using twum::test::robust_case;
using twum::test::torque_problem;

namespace {

const std::vector<double> kDesign{160.0};

// Response of C5: c . X with X_k = k + 0.1 k Z_k.
RobustProblem sum_problem() {
  return response_problem(5, Law::normal, [](std::span<const double> z) {
    const double c[] = {1, -2, 0.5, 0, 3};
    Evaluation answer{{0.0}, {}, {}, {}};
    for (std::size_t k = 0; k < 5; ++k) {
      const auto mean = static_cast<double>(k + 1);
      answer.values[0] += c[k] * (mean + 0.1 * mean * z[k]);
      answer.jacobian.push_back(c[k] * 0.1 * mean);
    }
    return answer;
  });
}

}  // namespace

TEST_CASE("FORM is exact where a limit is linear in the normal numbers (U3.2)", "[optim][robust]") {
  // The worst margin at the distance of the exact index is zero.
  const auto problem = sum_problem();
  const std::vector<double> x{0.5};
  const auto c5 = inverse_form(problem, {0, 1.0, 5.0, true}, x, robust_case("C5", "beta"), {});
  // Twelve digits of the table times the spread 1.56.
  CHECK(c5.at.value == Approx(0.0).margin(1e-10));
  CHECK(c5.by_beta == Approx(-robust_case("C5", "sd")).epsilon(1e-10));
  const auto c5c =
      inverse_form(problem, {0, 1.0, 9.59287509798, true}, x, robust_case("C5c", "beta"), {});
  CHECK(c5c.at.value == Approx(0.0).margin(1e-10));
}

TEST_CASE("FORM is exact where the logarithm of a limit is linear (U3.2, U1.2)",
          "[optim][robust]") {
  const auto worst = inverse_form(torque_problem(Law::lognormal), {0, 1.0, 0.7, true}, kDesign,
                                  robust_case("C1c", "FORM beta of holding_torque >= 0.7 N.m"), {});
  CHECK(worst.converged);
  CHECK(worst.at.value == Approx(0.0).margin(1e-10));
}

TEST_CASE("the most probable failing point of a product of normal inputs (U3.2)",
          "[optim][robust]") {
  const auto worst = inverse_form(torque_problem(Law::normal), {0, 1.0, 0.7, true}, kDesign,
                                  robust_case("C2b", "FORM beta of holding_torque >= 0.7 N.m"), {});
  CHECK(worst.converged);
  // Twelve digits of the index times the slope 0.09.
  CHECK(worst.at.value == Approx(0.0).margin(1e-11));
}

TEST_CASE("the worst margin of bounded inputs is the least on the sphere (U1.3, U1.4)",
          "[optim][robust]") {
  // Two inputs: the least torque on the circle by a fine scan, which knows nothing of slopes.
  for (const Law law : {Law::uniform, Law::triangular}) {
    auto problem = torque_problem(law);
    for (RandomInput& input : problem.inputs) input.above = 2.0 * input.spread;
    for (const double beta : {0.5, 1.5, 3.0, 4.5}) {
      CAPTURE(static_cast<int>(law), beta);
      const auto worst = inverse_form(problem, {0, 1.0, 0.7, true}, kDesign, beta, {});
      double least = 1e9;
      constexpr int kSteps = 20000;
      for (int i = 0; i < kSteps; ++i) {
        const double t = 2.0 * 3.14159265358979 * i / kSteps;
        const double mu = problem.inputs[0].at(0.2, beta * std::cos(t)).value;
        const double force = problem.inputs[1].at(160.0, beta * std::sin(t)).value;
        least = std::min(least, mu * force * 26.5e-3 - 0.7);
      }
      CHECK(worst.converged);
      // The scan misses the least by at most its curvature (below 1) times half a step squared: 2e-8.
      CHECK(worst.at.value <= least + 1e-12);
      CHECK(worst.at.value >= least - 5e-8);
    }
  }
}

TEST_CASE("derivatives of the worst margin agree with differences (U3.3)", "[optim][robust]") {
  for (const Law law : {Law::normal, Law::lognormal, Law::uniform}) {
    const auto problem = torque_problem(law);
    const Margin margin{0, -1.0, 1.0};
    for (const double beta : {-1.5, 0.7, 2.6}) {
      CAPTURE(static_cast<int>(law), beta);
      const auto value = [&](double force, double b) {
        const std::vector<double> x{force};
        return inverse_form(problem, margin, x, b, {}).at.value;
      };
      const auto worst = inverse_form(problem, margin, kDesign, beta, {});
      const double h = 1e-5;
      // Central differences: rounding eps / h = 2e-11 and h^2 = 1e-10 of curvatures below 1.
      CHECK(worst.at.by_design[0] ==
            Approx((value(160 + h, beta) - value(160 - h, beta)) / (2 * h)).epsilon(1e-6));
      CHECK(worst.by_beta ==
            Approx((value(160, beta + h) - value(160, beta - h)) / (2 * h)).epsilon(1e-6));
    }
  }
}

TEST_CASE("a curved limit with two worst points leads to one of them, not to the saddle between",
          "[optim][robust]") {
  // C10: on |z| = beta the margin 3 - z1 - 0.2 z2^2 is least at z1 = 2.5, not at (beta, 0).
  const auto problem = response_problem(2, Law::normal, [](std::span<const double> z) {
    return Evaluation{{3.0 - z[0] - 0.2 * z[1] * z[1]}, {-1.0, -0.4 * z[1]}, {}, {}};
  });
  const double beta = robust_case("C10", "MPP beta (two MPPs, z1=2.5, z2=+-sqrt 2.5)");
  const std::vector<double> x{0.5};
  const double aside = std::sqrt(1.0 - 0.98 * 0.98);
  const auto worst =
      inverse_form(problem, {0, 1.0, 0.0, true}, x, beta, std::vector<double>{0.98, aside});
  // The steps close in on the worst point by a third of the way each, since the limit is curved nearly as much as the
  // sphere: G falls to its least from above. The saddle has 3 - beta = 0.042.
  CHECK(worst.at.value >= -1e-10);
  CHECK(worst.at.value <= 1e-6);
  const auto saddle = inverse_form(problem, {0, 1.0, 0.0, true}, x, beta, {});
  CHECK(saddle.at.value == Approx(3.0 - beta));
}

TEST_CASE("margins with slopes that are zero, not finite or of any size have an answer or a reason",
          "[optim][robust][edge]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> x{0.5};
  for (const Law law : {Law::normal, Law::uniform, Law::triangular})
    for (const double slope : {0.0, 1e-320, 1e-300, 1e-8, 1.0, 1e300, kInfinity, nan})
      for (const bool mixed : {false, true})
        for (const double beta : {-3.0, 0.0, 3.0}) {
          const auto problem = response_problem(2, law, [&](std::span<const double> z) {
            return Evaluation{{std::isfinite(slope) && slope < 1e200 ? 1.0 + slope * z[0] : 1.0},
                              {slope, mixed ? 1.0 : slope},
                              {},
                              {}};
          });
          CAPTURE(static_cast<int>(law), slope, mixed, beta);
          const auto worst = inverse_form(problem, {0, 1.0, 0.5, true}, x, beta, {});
          CHECK(worst.at.failure.empty());
          CHECK(std::isfinite(worst.at.value));
          if (!std::isfinite(slope)) CHECK_FALSE(worst.converged);
          // The point lies on the sphere, or at the design where nothing moves the margin.
          double size = 0;
          for (const double z : worst.at.z) size += z * z;
          if (worst.at.failure.empty() && slope != 0 && beta != 0 && worst.converged)
            CHECK((size == 0 || std::sqrt(size) == Approx(3.0).epsilon(1e-9)));
        }
}
