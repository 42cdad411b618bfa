// SPDX-License-Identifier: Apache-2.0
#include "torque_problem.hpp"

#include "robust/joint_risk.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <numbers>
#include <twum/optim/distributions.hpp>

using namespace twum::optim;
using twum::test::robust_case;

TEST_CASE("the yield of two limits is that of their joint normal law (U3.4, U3.5)",
          "[optim][robust]") {
  const std::vector<double> beta{2.5, 2.0};
  const auto yield = [&](double rho) {
    const std::vector<std::vector<double>> directions{{1.0, 0.0},
                                                      {rho, std::sqrt(1.0 - rho * rho)}};
    return 1.0 - joint_risk(beta, overlaps_of(beta, directions)).risk;
  };
  // Twelve digits of the table.
  CHECK(yield(0.6) == Approx(robust_case("C6", "yield_")).epsilon(1e-11));
  CHECK(yield(1.0) == Approx(robust_case("C6c", "p1")).epsilon(1e-11));
  CHECK(1.0 - joint_risk(beta, {}).risk == Approx(robust_case("C6", "bonferroni")).epsilon(1e-11));
  const Overlap opposed{0, 1, -0.6};
  CHECK(1.0 - joint_risk(beta, std::vector<Overlap>{opposed}).risk ==
        Approx(robust_case("C6b", "yield_")).epsilon(1e-11));
  const Overlap mirrored{0, 1, -1.0};
  CHECK(1.0 - joint_risk(beta, std::vector<Overlap>{mirrored}).risk ==
        Approx(robust_case("C6c", "m1")).epsilon(1e-11));
}

TEST_CASE("derivatives of the joint risk are those of the bivariate law (U3.7)",
          "[optim][robust]") {
  const std::vector<Overlap> overlap{{0, 1, 0.6}};
  const JointRisk joint = joint_risk(std::vector<double>{2.5, 2.0}, overlap);
  CHECK(-joint.by_beta[0] == Approx(robust_case("C6d", "d1")).epsilon(1e-10));
  CHECK(-joint.by_beta[1] == Approx(robust_case("C6d", "d2")).epsilon(1e-10));
}

TEST_CASE("limits that never fail add nothing, also beside others", "[optim][robust]") {
  const double never = std::numeric_limits<double>::infinity();
  const std::vector<Overlap> overlap{{0, 1, 0.6}};
  const JointRisk joint = joint_risk(std::vector<double>{never, 2.0}, overlap);
  CHECK(joint.risk == normal_cdf(-2.0));
  CHECK(joint.by_beta[0] == 0.0);
}

TEST_CASE("the bivariate normal law at the origin is Sheppard's", "[optim][robust]") {
  // P(Z1 <= 0, Z2 <= 0) = 1/4 + asin(rho) / (2 pi)
  for (const double rho : {-0.999, -0.6, 0.0, 0.3, 0.95, 0.999})
    CHECK(normal_cdf(0, 0, rho) ==
          Approx(0.25 + std::asin(rho) / (2 * std::numbers::pi)).epsilon(1e-12));
}
