// SPDX-License-Identifier: Apache-2.0
#include "fit_statistics.hpp"

#include <Eigen/SVD>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>

namespace twum::optim {
namespace {

using Eigen::Index;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// Columns of unit length, so that rank does not depend on units.
struct Scaled {
  Eigen::MatrixXd columns;
  Eigen::VectorXd size;
};

Scaled scaled_columns(const Eigen::MatrixXd& jacobian) {
  Scaled s{jacobian, Eigen::VectorXd::Ones(jacobian.cols())};
  for (Index j = 0; j < jacobian.cols(); ++j) {
    const double norm = jacobian.col(j).stableNorm();
    if (norm > 0.0) s.size[j] = norm;
    s.columns.col(j) /= s.size[j];
  }
  return s;
}

void name_undetermined(const Eigen::MatrixXd& v, Index rank, const std::vector<Index>& free,
                       LeastSquaresResult& result) {
  for (Index k = rank; k < v.cols(); ++k) {
    std::vector<std::string> names;
    for (Index j = 0; j < v.rows(); ++j)
      if (std::abs(v(j, k)) > 0.05)
        names.push_back(
            result.estimates[static_cast<std::size_t>(free[static_cast<std::size_t>(j)])].name);
    result.undetermined.push_back(std::move(names));
  }
}

// V S^-2 V^T over the determined part. A parameter with a share in the rest has no variance.
Eigen::MatrixXd inverse_normal(const Eigen::JacobiSVD<Eigen::MatrixXd>& svd, Index rank,
                               const Eigen::VectorXd& size) {
  const Eigen::MatrixXd& v = svd.matrixV();
  Eigen::MatrixXd half = v.leftCols(rank);
  for (Index k = 0; k < rank; ++k) half.col(k) /= svd.singularValues()[k];
  for (Index j = 0; j < half.rows(); ++j) half.row(j) /= size[j];
  Eigen::MatrixXd inverse = half * half.transpose();
  for (Index j = 0; j < v.rows(); ++j)
    if (v.row(j).tail(v.cols() - rank).norm() > 1e-6) {
      inverse.row(j).setConstant(kNan);
      inverse.col(j).setConstant(kNan);
    }
  return inverse;
}

void fill_estimates(const Eigen::MatrixXd& covariance, const std::vector<Index>& free, double t,
                    LeastSquaresResult& result) {
  const std::size_t n = result.estimates.size();
  result.covariance.assign(n * n, 0.0);
  result.correlation.assign(n * n, 0.0);
  for (std::size_t j = 0; j < n; ++j) {
    result.correlation[j * n + j] = 1.0;
    result.estimates[j].low = result.estimates[j].high = result.estimates[j].value;
  }
  for (std::size_t i = 0; i < free.size(); ++i) {
    const auto a = static_cast<std::size_t>(free[i]);
    const auto row = static_cast<Index>(i);
    Estimate& e = result.estimates[a];
    e.standard_deviation = std::sqrt(covariance(row, row));
    e.low = e.value - t * e.standard_deviation;
    e.high = e.value + t * e.standard_deviation;
    for (std::size_t k = 0; k < free.size(); ++k) {
      const auto b = static_cast<std::size_t>(free[k]);
      const auto column = static_cast<Index>(k);
      result.covariance[a * n + b] = covariance(row, column);
      if (a != b)
        result.correlation[a * n + b] = covariance(row, column) / std::sqrt(covariance(row, row)) /
                                        std::sqrt(covariance(column, column));
    }
  }
}

}  // namespace

void fit_statistics(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& residuals,
                    const std::vector<Index>& free, const LeastSquaresOptions& options,
                    LeastSquaresResult& result) {
  const Index n = jacobian.cols();
  result.degrees_of_freedom = static_cast<std::size_t>(residuals.size() - n);
  const double freedom = static_cast<double>(result.degrees_of_freedom);
  result.residual_deviation = freedom > 0.0 ? residuals.stableNorm() / std::sqrt(freedom) : kNan;
  if (n == 0) return fill_estimates({}, free, 0.0, result);
  const Scaled scaled = scaled_columns(jacobian);
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(scaled.columns,
                                              Eigen::ComputeThinU | Eigen::ComputeThinV);
  Index rank = 0;
  while (rank < n && svd.singularValues()[rank] > options.rank_tolerance * svd.singularValues()[0])
    ++rank;
  result.rank = static_cast<std::size_t>(rank);
  name_undetermined(svd.matrixV(), rank, free, result);
  const double variance = result.residual_deviation * result.residual_deviation;
  const Eigen::MatrixXd covariance = variance * inverse_normal(svd, rank, scaled.size);
  const double t = freedom > 0.0
                       ? quantile(boost::math::students_t(freedom), 0.5 + 0.5 * options.confidence)
                       : kNan;
  fill_estimates(covariance, free, t, result);
}

}  // namespace twum::optim
