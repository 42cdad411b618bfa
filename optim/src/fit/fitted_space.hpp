// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/least_squares.hpp>

#include <Eigen/Core>
#include <Eigen/QR>
#include <cstddef>
#include <vector>

namespace twum::inline v0_1::optim {

/// Columns of the Jacobian by the parameters that are not at a bound. Internal.
inline Eigen::MatrixXd free_jacobian(const Residuals& at, const LeastSquaresResult& fit) {
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  std::vector<Eigen::Index> free;
  for (std::size_t j = 0; j < fit.estimates.size(); ++j)
    if (!fit.estimates[j].at_bound) free.push_back(static_cast<Eigen::Index>(j));
  const Eigen::Map<const RowMajor> all(at.jacobian.data(),
                                       static_cast<Eigen::Index>(at.values.size()),
                                       static_cast<Eigen::Index>(fit.estimates.size()));
  return all(Eigen::all, free);
}

/// Columns of length 1, so that rank does not depend on units. Internal.
inline Eigen::MatrixXd unit_columns(Eigen::MatrixXd columns) {
  for (Eigen::Index k = 0; k < columns.cols(); ++k)
    if (const double size = columns.col(k).stableNorm(); size > 0.0) columns.col(k) /= size;
  return columns;
}

/// Orthonormal basis of the column space. The squared norm of a row is the leverage of its residual. Internal.
inline Eigen::MatrixXd fitted_space(const Eigen::MatrixXd& columns) {
  if (columns.cols() == 0) return columns;
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(unit_columns(columns));
  qr.setThreshold(1e-10);
  return qr.householderQ() * Eigen::MatrixXd::Identity(columns.rows(), qr.rank());
}

/// The estimate of a parameter is the coordinate along its row, in this basis and in parts of its column's length. Internal.
inline Eigen::MatrixXd parameter_rows(const Eigen::MatrixXd& columns,
                                      const Eigen::MatrixXd& basis) {
  return unit_columns(columns).completeOrthogonalDecomposition().pseudoInverse() * basis;
}

}  // namespace twum::inline v0_1::optim
