// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/robust_problem.hpp>

namespace twum::inline v0_1::optim {

/// A statistic of a response and its derivatives, U2.1 to U2.3.
struct Moment {
  double value{0.0};
  std::vector<double> by_design;  ///< by each variable
  std::vector<double> by_spread;  ///< s d/ds for each input
  std::string failure{};          ///< if not empty, the other members are not valid
};

/// Mean or standard deviation over the products z_1 .. z_N of the rows of `sample`; products without an answer are
/// left out. It fails if their share exceeds kMostLostOfAMean.
Moment moment(const RobustProblem& problem, const StatisticTarget& target,
              std::span<const double> x, const std::vector<std::vector<double>>& sample);

/// Share of products without an answer beyond which the derivative of a mean would be wrong.
inline constexpr double kMostLostOfAMean = 1e-3;

/// The fixed sample of a problem: 256 points of a scrambled Sobol sequence, as normal numbers.
std::vector<std::vector<double>> moment_sample(const RobustProblem& problem, std::uint64_t seed);

}  // namespace twum::inline v0_1::optim
