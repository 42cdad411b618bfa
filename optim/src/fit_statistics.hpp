// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/least_squares.hpp>

#include <Eigen/Core>

namespace twum::optim {

/// Fills rank, deviations, intervals, covariance and correlation from the Jacobian (user units) in
/// the free parameters.
void fit_statistics(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& residuals,
                    const std::vector<Eigen::Index>& free, const LeastSquaresOptions& options,
                    LeastSquaresResult& result);

}  // namespace twum::optim
