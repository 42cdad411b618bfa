// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/least_squares.hpp>

#include <Eigen/Core>
#include <limits>

namespace twum::inline v0_1::optim {

/// End point of a fit.
struct FittedState {
  Eigen::MatrixXd jacobian;  // of all parameters, in user units
  const Eigen::VectorXd& residuals;
  const std::vector<Eigen::Index>& free;  // parameters that are not at a bound
  const std::vector<Variable>& parameters;
  std::size_t count;  // measured residuals, of which condensed ones are fewer
  double scatter{
      std::numeric_limits<double>::quiet_NaN()};  // if it does not follow from the residuals
};

/// Computes rank, deviations, intervals, covariance, correlation, and the sensitivities to the parameters at a bound.
void fit_statistics(const FittedState& state, const LeastSquaresOptions& options,
                    LeastSquaresResult& result);

}  // namespace twum::inline v0_1::optim
