// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace twum::inline v0_1::optim {

/// Two limits that may fail together, U3.5: the contribution of `later` to the risk is reduced by its overlap with
/// `earlier`.
struct Overlap {
  std::size_t later{0};
  std::size_t earlier{0};
  double correlation{0.0};  ///< rho of the two margins
};

/// Probability that a limit of the set fails, and its derivatives by the reliability indices.
struct JointRisk {
  double risk{0.0};
  std::vector<double> by_beta;
};

/// R(beta): U3.4 minus the given overlaps U3.5. An infinite index has no risk.
JointRisk joint_risk(std::span<const double> beta, std::span<const Overlap> overlaps);

/// The overlaps of limits with these indices and directions alpha. In order of falling risk, each limit is paired
/// with the earlier one that has the largest overlap. None if they change the risk by less than 1 %.
std::vector<Overlap> overlaps_of(std::span<const double> beta,
                                 std::span<const std::vector<double>> directions);

}  // namespace twum::inline v0_1::optim
