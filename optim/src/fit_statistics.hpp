// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/least_squares.hpp>

#include <Eigen/Core>
#include <limits>

namespace twum::optim {

/// Where a fit has ended.
struct FittedState {
  Eigen::MatrixXd jacobian;  // of all parameters, in user units
  const Eigen::VectorXd& residuals;
  const std::vector<Eigen::Index>& free;  // parameters that no bound holds
  const std::vector<Variable>& parameters;
  double scatter{
      std::numeric_limits<double>::quiet_NaN()};  // where it does not follow from the residuals
};

/// Fills rank, deviations, intervals, covariance, correlation, and what follows the held parameters.
void fit_statistics(const FittedState& state, const LeastSquaresOptions& options,
                    LeastSquaresResult& result);

}  // namespace twum::optim
