// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/robust_problem.hpp>

namespace twum::optim {

/// Mean or standard deviation of a response over a fixed sample, and its derivatives by the design, U2.1 and U2.2.
struct Moment {
  double value{0.0};
  std::vector<double> by_design;
  std::string failure;
};

/// Over the products z_1 .. z_N of the rows of `sample`; products without an answer are left out, and more than a thousandth
/// of them is a failure.
Moment moment(const RobustProblem& problem, const StatisticTarget& target,
              std::span<const double> x, const std::vector<std::vector<double>>& sample);

/// The fixed sample of a problem: 256 points of a scrambled Sobol sequence, as normal numbers.
std::vector<std::vector<double>> moment_sample(const RobustProblem& problem, std::uint64_t seed);

}  // namespace twum::optim
