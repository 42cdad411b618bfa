// SPDX-License-Identifier: Apache-2.0
#include <twum/optim/least_squares.hpp>

#include <Eigen/Core>
#include <Eigen/QR>

namespace twum::inline v0_1::optim {
namespace {

using Eigen::Index;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// [J r]
Eigen::MatrixXd beside_each_other(const Residuals& residuals) {
  const auto m = static_cast<Index>(residuals.values.size());
  const auto n = static_cast<Index>(residuals.jacobian.size()) / m;
  Eigen::MatrixXd both(m, n + 1);
  both.leftCols(n) = Eigen::Map<const RowMajor>(residuals.jacobian.data(), m, n);
  both.col(n) = Eigen::Map<const Eigen::VectorXd>(residuals.values.data(), m);
  return both;
}

}  // namespace

// Reflections keep the length of each column, whatever the others are: no digit is lost where units differ, nor where the
// residuals are rounding.
Residuals condensed(const Residuals& residuals) {
  if (!residuals.failure.empty() || residuals.values.empty()) return residuals;
  const Eigen::MatrixXd both = beside_each_other(residuals);
  if (both.rows() <= both.cols()) return residuals;
  const Index rows = both.cols(), n = rows - 1;
  const RowMajor r = Eigen::HouseholderQR<Eigen::MatrixXd>(both)
                         .matrixQR()
                         .topRows(rows)
                         .triangularView<Eigen::Upper>();
  Residuals few;
  few.stand_for = residuals.count();
  for (Index i = 0; i < rows; ++i) {
    few.values.push_back(r(i, n));
    few.jacobian.insert(few.jacobian.end(), r.row(i).data(), r.row(i).data() + n);
  }
  return few;
}

}  // namespace twum::inline v0_1::optim
