// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/least_squares.hpp>

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

namespace twum::inline v0_1::optim {

/// What each group of residuals tells of the parameters (L9.2). Internal.
struct GroupShares {
  /// @param basis   orthonormal, of the fitted space
  /// @param groups  of each residual
  GroupShares(const Eigen::MatrixXd& basis, std::span<const std::size_t> groups, std::size_t count);

  std::vector<Eigen::MatrixXd> shares;  ///< Q_k^T Q_k; their sum is 1
  Eigen::VectorXd counts;               ///< m_k, residuals
};

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

}  // namespace twum::inline v0_1::optim
