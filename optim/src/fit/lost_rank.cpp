// SPDX-License-Identifier: Apache-2.0
#include <twum/optim/lost_rank.hpp>

#include <twum/base/error.hpp>

#include "fit/fit_statistics.hpp"

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::optim {
namespace {

// Largest step in parts of a range. A simple fold then has a relative singular value of about a thousandth of its usual one,
// far above the tolerance of the rank, 1e-10; rounding errors stay far below it.
constexpr double kNeighbourStep = 4e-3;

// The value beside that of the fit; parameters differ in their steps, so that no product or ratio of two stays.
double neighbour_value(const Variable& v, const Estimate& e, std::size_t number, double sign) {
  if (e.at_bound || v.lower == v.upper) return e.value;
  const double part =
      sign * kNeighbourStep * (0.5 + 0.5 * std::fmod(0.618034 * double(number + 1), 1.0));
  if (v.scale == Scale::log)
    return std::clamp(e.value * std::exp(part * std::log(v.upper / v.lower)), v.lower, v.upper);
  const double range = v.upper - v.lower;
  const double size = std::isfinite(range) ? range : std::max(std::abs(e.value), 1.0);
  return std::clamp(e.value + part * size, v.lower, v.upper);
}

}  // namespace

std::vector<std::vector<std::string>> lost_rank(const std::vector<Variable>& parameters,
                                                const ResidualFunction& residuals,
                                                const LeastSquaresOptions& options,
                                                const LeastSquaresResult& fit) {
  using Eigen::Index;
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  std::vector<std::vector<std::string>> sets = fit.undetermined;
  std::size_t rank = fit.rank;
  std::vector<Index> free;
  for (std::size_t j = 0; j < fit.estimates.size(); ++j)
    if (!fit.estimates[j].at_bound) free.push_back(static_cast<Index>(j));
  for (const double sign : {1.0, -1.0}) {
    if (rank == free.size()) break;
    std::vector<double> b;
    for (std::size_t j = 0; j < fit.estimates.size(); ++j)
      b.push_back(neighbour_value(parameters[j], fit.estimates[j], j, sign));
    Residuals there;
    try {
      there = residuals(b);
    } catch (const EvaluationError& error) {
      there.failure = error.reason();
    }
    if (!there.failure.empty()) continue;
    const auto count = static_cast<Index>(there.values.size());
    const Eigen::MatrixXd jacobian =
        Eigen::Map<const RowMajor>(there.jacobian.data(), count, static_cast<Index>(b.size()));
    const Eigen::VectorXd values = Eigen::Map<const Eigen::VectorXd>(there.values.data(), count);
    LeastSquaresResult found;
    found.estimates = fit.estimates;
    fit_statistics({jacobian, values, free, parameters, there.count()}, options, found);
    if (found.rank <= rank) continue;
    rank = found.rank;
    sets = found.undetermined;
  }
  return sets;
}

}  // namespace twum::inline v0_1::optim
