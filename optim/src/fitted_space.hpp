// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/QR>

namespace twum::optim {

/// Orthonormal basis of the column space. The squared norm of a row is the leverage of its residual. Internal.
inline Eigen::MatrixXd fitted_space(Eigen::MatrixXd columns) {
  if (columns.cols() == 0) return columns;
  for (Eigen::Index k = 0; k < columns.cols(); ++k)
    if (const double size = columns.col(k).stableNorm(); size > 0.0) columns.col(k) /= size;
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(columns);
  qr.setThreshold(1e-10);
  return qr.householderQ() * Eigen::MatrixXd::Identity(columns.rows(), qr.rank());
}

}  // namespace twum::optim
