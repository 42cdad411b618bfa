// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/least_squares.hpp>

#include <Eigen/Core>
#include <vector>

namespace twum::optim {

/// What estimated deviations of groups of residuals make of standard deviations of parameters (L9.2, L9.3). Internal.
class KenwardRoger {
 public:
  /// @param shares  H_k of each group, in an orthonormal basis of the fitted space in which their sum is 1
  /// @param counts  residuals of each group
  KenwardRoger(const std::vector<Eigen::MatrixXd>& shares, const Eigen::VectorXd& counts);

  /// Of a parameter whose estimate is the coordinate along c, of length 1.
  SmallSample of(const Eigen::VectorXd& c) const;

 private:
  const std::vector<Eigen::MatrixXd>& shares_;
  Eigen::MatrixXd covariance_;  // W, of the relative errors of the estimated squared deviations
  Eigen::MatrixXd more_;        // M
};

}  // namespace twum::optim
