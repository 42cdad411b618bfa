// SPDX-License-Identifier: Apache-2.0
#include "fit/fit_statistics.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <twum/optim/distributions.hpp>

namespace twum::inline v0_1::optim {
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

// V S^-2 V^T over the determined part. A parameter with a share in the undetermined part has no variance.
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

// Covariance of the free parameters, with what scatters of groups add to the standard deviations (L9.3).
Eigen::MatrixXd widened(Eigen::MatrixXd covariance, const FittedState& state,
                        const LeastSquaresOptions& options) {
  for (std::size_t i = 0; i < state.free.size() && !options.small_sample.empty(); ++i) {
    const double factor = options.small_sample[static_cast<std::size_t>(state.free[i])].widening;
    covariance.row(static_cast<Index>(i)) *= factor;
    covariance.col(static_cast<Index>(i)) *= factor;
  }
  return covariance;
}

// Half width of the interval of a parameter in its standard deviations.
double half_width(std::size_t parameter, const LeastSquaresOptions& options,
                  const LeastSquaresResult& result) {
  if (options.small_sample.empty() || !std::isfinite(result.student_t)) return result.student_t;
  const SmallSample& sample = options.small_sample[parameter];
  if (sample.quantile > 0.0) return sample.quantile;
  return student_quantile(sample.freedom, 0.5 + 0.5 * options.confidence);
}

void fill_estimates(const Eigen::MatrixXd& covariance, const FittedState& state,
                    const LeastSquaresOptions& options, LeastSquaresResult& result) {
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
    const double t = half_width(a, options, result);
    set_interval(e, state.parameters[a].scale, t);
    e.rise = t * result.scatter;
    if (!options.small_sample.empty()) e.rise *= options.small_sample[a].widening;
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

// To first order the free parameters compensate for a held one: the least squares solution of J_free d = -J_held.
// Undetermined parameters have no such solution.
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

// Degrees of freedom that the scatter is known to; of groups the fewest of a free parameter.
double known_to(const FittedState& state, const LeastSquaresOptions& options,
                const LeastSquaresResult& result) {
  double freedom = static_cast<double>(result.degrees_of_freedom);
  for (const Index j : state.free)
    if (!options.small_sample.empty())
      freedom = std::min(freedom, options.small_sample[static_cast<std::size_t>(j)].freedom);
  return freedom;
}

// Scatter of the residuals, and what follows from it for intervals of one parameter and of all together.
void fill_scatter(const FittedState& state, const LeastSquaresOptions& options,
                  LeastSquaresResult& result) {
  const std::size_t parameters = state.free.size();
  const double freedom = known_to(state, options, result);
  const double count = static_cast<double>(parameters);
  const bool known = result.scatter_known = std::isfinite(options.deviation);
  result.scatter = known ? options.deviation : result.residual_deviation;
  if (std::isfinite(state.scatter)) result.scatter = state.scatter;
  const double upper = 0.5 + 0.5 * options.confidence;
  result.student_t = known           ? normal_quantile(upper)
                     : freedom > 0.0 ? student_quantile(freedom, upper)
                                     : kNan;
  for (const Index j : state.free)
    if (!options.small_sample.empty())
      result.student_t =
          std::max(result.student_t, options.small_sample[static_cast<std::size_t>(j)].quantile);
  double joint = kNan;  // L2.2, in units of the squared scatter
  if (parameters == 0)
    joint = 0.0;
  else if (known)
    joint = chi_square_quantile(count, options.confidence);
  else if (freedom > 0.0)
    joint = count * fisher_quantile(count, freedom, options.confidence);
  result.joint_limit = result.sum_of_squares + joint * result.scatter * result.scatter;
}

// Scale of a parameter's relative change: its value, or its range if the value is 0.
double size_of(const Variable& parameter, double value) {
  const double range = parameter.upper - parameter.lower;
  return value != 0.0 ? std::abs(value) : std::isfinite(range) ? range : 1.0;
}

// L2.3: singular vectors of the columns for relative changes.
void fill_directions(const Eigen::MatrixXd& columns, const FittedState& state,
                     LeastSquaresResult& result) {
  const Index n = columns.cols();
  Eigen::MatrixXd relative = columns;
  for (Index i = 0; i < n; ++i) {
    const auto j = static_cast<std::size_t>(state.free[static_cast<std::size_t>(i)]);
    relative.col(i) *= size_of(state.parameters[j], result.estimates[j].value);
  }
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(relative, Eigen::ComputeThinU | Eigen::ComputeThinV);
  for (Index k = n - 1; k >= 0; --k) {
    Eigen::VectorXd v = svd.matrixV().col(k);
    Index largest = 0;
    v.cwiseAbs().maxCoeff(&largest);
    const double size = v[largest];
    const std::vector<double> none(result.estimates.size(), 0.0);
    Direction direction{none, none, svd.singularValues()[k] / std::abs(size)};
    for (Index i = 0; i < n; ++i) {
      const auto j = static_cast<std::size_t>(state.free[static_cast<std::size_t>(i)]);
      direction.change[j] = v[i] / size;
      direction.part_norms[j] = relative.col(i).norm() * std::abs(v[i] / size);
    }
    result.directions.push_back(std::move(direction));
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
  result.degrees_of_freedom = state.count - state.free.size();
  const double freedom = static_cast<double>(result.degrees_of_freedom);
  result.residual_deviation =
      freedom > 0.0 ? state.residuals.stableNorm() / std::sqrt(freedom) : kNan;
  fill_scatter(state, options, result);
  if (n == 0) return fill_estimates({}, state, options, result);
  const Eigen::MatrixXd columns = free_columns(state);
  fill_directions(columns, state, result);
  const Scaled scaled = scaled_columns(columns);
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(scaled.columns,
                                              Eigen::ComputeThinU | Eigen::ComputeThinV);
  Index rank = 0;
  while (rank < n && svd.singularValues()[rank] > options.rank_tolerance * svd.singularValues()[0])
    ++rank;
  result.rank = static_cast<std::size_t>(rank);
  name_undetermined(svd.matrixV(), rank, state.free, result);
  const double variance = result.scatter * result.scatter;
  const Eigen::MatrixXd covariance = variance * inverse_normal(svd, rank, scaled.size);
  fill_estimates(widened(covariance, state, options), state, options, result);
  fill_follows(svd, scaled.size, state, result);
}

}  // namespace twum::inline v0_1::optim
