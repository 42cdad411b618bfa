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
// In double precision throughout: long double differs from machine to machine, and valgrind has none.
using StudentsT = boost::math::students_t_distribution<
    double, boost::math::policies::policy<boost::math::policies::promote_double<false>>>;

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

// A log scale is fitted in the logarithm, where its interval is symmetric: it cannot reach 0.
void set_interval(Estimate& e, Scale scale, double t) {
  const double half = t * e.standard_deviation;
  const bool log = scale == Scale::log;
  e.low = log ? e.value * std::exp(-half / e.value) : e.value - half;
  e.high = log ? e.value * std::exp(half / e.value) : e.value + half;
}

void fill_estimates(const Eigen::MatrixXd& covariance, const FittedState& state,
                    LeastSquaresResult& result) {
  const std::size_t n = result.estimates.size();
  result.covariance.assign(n * n, 0.0);
  result.correlation.assign(n * n, 0.0);
  for (std::size_t j = 0; j < n; ++j) {
    result.correlation[j * n + j] = 1.0;
    result.estimates[j].low = result.estimates[j].high = result.estimates[j].value;
  }
  for (std::size_t i = 0; i < state.free.size(); ++i) {
    const auto a = static_cast<std::size_t>(state.free[i]);
    const auto row = static_cast<Index>(i);
    Estimate& e = result.estimates[a];
    e.standard_deviation = std::sqrt(covariance(row, row));
    set_interval(e, state.parameters[a].scale, result.student_t);
    for (std::size_t k = 0; k < state.free.size(); ++k) {
      const auto b = static_cast<std::size_t>(state.free[k]);
      const auto column = static_cast<Index>(k);
      result.covariance[a * n + b] = covariance(row, column);
      if (a != b)
        result.correlation[a * n + b] = covariance(row, column) / std::sqrt(covariance(row, row)) /
                                        std::sqrt(covariance(column, column));
    }
  }
}

// To first order the free parameters make up for a held one as well as they can: the least squares
// solution of J_free d = -J_held. Where they are not determined, neither is what they would do.
void fill_follows(const Eigen::JacobiSVD<Eigen::MatrixXd>& svd, const Eigen::VectorXd& size,
                  const FittedState& state, LeastSquaresResult& result) {
  const std::size_t n = result.estimates.size();
  const bool determined = result.rank == state.free.size();
  for (std::size_t j = 0; j < n; ++j) {
    if (!result.estimates[j].at_bound) continue;
    const Eigen::VectorXd d =
        -svd.solve(state.jacobian.col(static_cast<Index>(j))).cwiseQuotient(size);
    for (std::size_t i = 0; i < state.free.size(); ++i)
      result.follows[static_cast<std::size_t>(state.free[i]) * n + j] =
          determined ? d[static_cast<Index>(i)] : kNan;
  }
}

Eigen::MatrixXd free_columns(const FittedState& state) {
  Eigen::MatrixXd columns(state.residuals.size(), static_cast<Index>(state.free.size()));
  for (std::size_t i = 0; i < state.free.size(); ++i)
    columns.col(static_cast<Index>(i)) = state.jacobian.col(state.free[i]);
  return columns;
}

}  // namespace

void fit_statistics(const FittedState& state, const LeastSquaresOptions& options,
                    LeastSquaresResult& result) {
  const auto n = static_cast<Index>(state.free.size());
  result.follows.assign(result.estimates.size() * result.estimates.size(), 0.0);
  result.degrees_of_freedom = static_cast<std::size_t>(state.residuals.size() - n);
  const double freedom = static_cast<double>(result.degrees_of_freedom);
  result.residual_deviation =
      freedom > 0.0 ? state.residuals.stableNorm() / std::sqrt(freedom) : kNan;
  result.student_t =
      freedom > 0.0 ? quantile(StudentsT(freedom), 0.5 + 0.5 * options.confidence) : kNan;
  if (n == 0) return fill_estimates({}, state, result);
  const Scaled scaled = scaled_columns(free_columns(state));
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(scaled.columns,
                                              Eigen::ComputeThinU | Eigen::ComputeThinV);
  Index rank = 0;
  while (rank < n && svd.singularValues()[rank] > options.rank_tolerance * svd.singularValues()[0])
    ++rank;
  result.rank = static_cast<std::size_t>(rank);
  name_undetermined(svd.matrixV(), rank, state.free, result);
  const double variance = result.residual_deviation * result.residual_deviation;
  const Eigen::MatrixXd covariance = variance * inverse_normal(svd, rank, scaled.size);
  fill_estimates(covariance, state, result);
  fill_follows(svd, scaled.size, state, result);
}

}  // namespace twum::optim
