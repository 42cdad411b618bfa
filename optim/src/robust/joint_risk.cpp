// SPDX-License-Identifier: Apache-2.0
#include "robust/joint_risk.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <twum/optim/distributions.hpp>

namespace twum::inline v0_1::optim {
namespace {

constexpr double kOneLimit = 0.999;   // correlation from which two limits are one
constexpr double kNegligible = 0.01;  // of the risk

struct Both {
  double probability{0.0};
  double by_later{0.0};
  double by_earlier{0.0};
};

// Phi2(-b, -c; rho) and its derivatives by b and c, U3.7.
Both both_fail(double b, double c, double rho) {
  if (rho >= kOneLimit) {
    const double larger = std::max(b, c);
    const double slope = -normal_density(larger);
    return {normal_cdf(-larger), b >= c ? slope : 0.0, b >= c ? 0.0 : slope};
  }
  if (rho <= -kOneLimit) {
    const double share = normal_cdf(-b) - normal_cdf(c);
    if (share <= 0.0) return {};
    return {share, -normal_density(b), -normal_density(c)};
  }
  const double root = std::sqrt(1.0 - rho * rho);
  const auto slope = [&](double own, double other) {
    if (std::isinf(own)) return 0.0;
    return -normal_density(own) * normal_cdf((rho * own - other) / root);
  };
  return {normal_cdf(-b, -c, rho), slope(b, c), slope(c, b)};
}

}  // namespace

JointRisk joint_risk(std::span<const double> beta, std::span<const Overlap> overlaps) {
  JointRisk joint;
  for (const double b : beta) {
    joint.risk += normal_cdf(-b);
    joint.by_beta.push_back(-normal_density(b));
  }
  for (const Overlap& pair : overlaps) {
    const Both both = both_fail(beta[pair.later], beta[pair.earlier], pair.correlation);
    joint.risk -= both.probability;
    joint.by_beta[pair.later] -= both.by_later;
    joint.by_beta[pair.earlier] -= both.by_earlier;
  }
  return joint;
}

std::vector<Overlap> overlaps_of(std::span<const double> beta,
                                 std::span<const std::vector<double>> directions) {
  std::vector<std::size_t> order(beta.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return beta[a] < beta[b]; });
  std::vector<Overlap> list;
  double shared = 0.0;
  for (std::size_t i = 1; i < order.size(); ++i) {
    Overlap largest;
    double most = 0.0;
    for (std::size_t l = 0; l < i; ++l) {
      const auto& a = directions[order[i]];
      const auto& b = directions[order[l]];
      if (a.empty() || b.empty()) continue;
      const double rho = std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
      const double both = both_fail(beta[order[i]], beta[order[l]], rho).probability;
      if (both <= most) continue;
      most = both;
      largest = {order[i], order[l], rho};
    }
    if (most == 0.0) continue;
    shared += most;
    list.push_back(largest);
  }
  if (shared < kNegligible * joint_risk(beta, {}).risk) list.clear();
  return list;
}

}  // namespace twum::inline v0_1::optim
