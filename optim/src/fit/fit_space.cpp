// SPDX-License-Identifier: Apache-2.0
#include "fit/fit_space.hpp"

#include <twum/base/error.hpp>

#include "fit/fit_statistics.hpp"

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::optim {

using Eigen::Index;

FitSpace::FitSpace(const std::vector<Variable>& parameters, const ResidualFunction& residuals,
                   const LeastSquaresOptions& options)
    : parameters_(parameters), function_(residuals), options_(options) {
  const Index n = static_cast<Index>(parameters.size());
  t_.resize(n);
  lower_.resize(n);
  upper_.resize(n);
  for (Index j = 0; j < n; ++j) set_range_and_start(j);
}

void FitSpace::set_range_and_start(Index j) {
  const Variable& v = parameter(j);
  const bool log = v.scale == Scale::log;
  if (!(v.lower <= v.upper) || (log && !(v.lower > 0.0)))
    throw InputError("parameter '" + v.name + "': the bounds do not fit");
  double start = v.start;
  if (std::isnan(start)) start = log ? std::sqrt(v.lower * v.upper) : 0.5 * (v.lower + v.upper);
  start = std::clamp(start, v.lower, v.upper);
  if (!std::isfinite(start)) throw InputError("parameter '" + v.name + "': it needs a start");
  t_[j] = log ? std::log(start) : start;
  lower_[j] = log ? std::log(v.lower) : v.lower;
  upper_[j] = log ? std::log(v.upper) : v.upper;
}

std::vector<double> FitSpace::user(const Eigen::VectorXd& t) const {
  std::vector<double> b;
  for (Index j = 0; j < t.size(); ++j) {
    const Variable& v = parameter(j);
    b.push_back(std::clamp(v.scale == Scale::log ? std::exp(t[j]) : t[j], v.lower, v.upper));
  }
  return b;
}

bool FitSpace::start() {
  Eigen::VectorXd r;
  Eigen::MatrixXd j;
  if (!evaluate(t_, r, j)) return false;
  move(Eigen::VectorXd(t_), r, j);
  first_ = r_.norm();
  return true;
}

void FitSpace::move(const Eigen::VectorXd& t, const Eigen::VectorXd& r, const Eigen::MatrixXd& j) {
  t_ = t;
  r_ = r;
  j_ = j;
}

bool FitSpace::evaluate(const Eigen::VectorXd& t, Eigen::VectorXd& r, Eigen::MatrixXd& jacobian) {
  const auto b = user(t);
  ++counters_.evaluations;
  ++counters_.gradients;
  Residuals found;
  try {
    found = function_(b);
    count_ = std::max(count_, found.count());
  } catch (const EvaluationError& e) {
    found.failure = e.reason();
  }
  if (found.failure.empty() && !to_search_scale(found, b, r, jacobian))
    found.failure = "not-finite";
  if (!found.failure.empty()) ++counters_.failures[found.failure];
  return found.failure.empty();
}

bool FitSpace::to_search_scale(const Residuals& found, const std::vector<double>& b,
                               Eigen::VectorXd& r, Eigen::MatrixXd& jacobian) const {
  const Index m = static_cast<Index>(found.values.size());
  const Index n = t_.size();
  if (found.jacobian.size() != found.values.size() * b.size())
    throw InputError("least squares: the Jacobian has the wrong size");
  if (static_cast<Index>(found.count()) < n - (lower_.array() == upper_.array()).count())
    throw InputError("least squares: there are fewer residuals than free parameters");
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  r = Eigen::Map<const Eigen::VectorXd>(found.values.data(), m);
  jacobian = Eigen::Map<const RowMajor>(found.jacobian.data(), m, n);
  for (Index j = 0; j < n; ++j)
    if (parameter(j).scale == Scale::log) jacobian.col(j) *= b[static_cast<std::size_t>(j)];
  return r.allFinite() && jacobian.allFinite();
}

bool FitSpace::held(Index j) const {
  if (lower_[j] == upper_[j]) return true;
  const double slope = j_.col(j).dot(r_);
  return (t_[j] <= lower_[j] && slope >= 0.0) || (t_[j] >= upper_[j] && slope <= 0.0);
}

std::vector<Index> FitSpace::free_parameters() const {
  std::vector<Index> free;
  for (Index j = 0; j < t_.size(); ++j)
    if (!held(j)) free.push_back(j);
  return free;
}

// Estimated size of the numbers whose difference the residuals are: the terms of their linear part and, unless the
// search was cut short, the residuals at the start.
double FitSpace::size_of_terms(bool cut_short) const {
  double size = cut_short ? 0.0 : first_;
  for (Index j = 0; j < t_.size(); ++j)
    size += j_.col(j).norm() * (parameter(j).scale == Scale::log ? 1.0 : std::abs(t_[j]));
  return size;
}

// Cosine between residuals and columns: zero at an optimum, whatever the units.
double FitSpace::gradient_cosine(const std::vector<Index>& free) const {
  double worst = 0.0;
  const double size = r_.norm();
  for (const Index j : free)
    if (const double c = j_.col(j).norm(); c > 0.0 && size > 0.0)
      worst = std::max(worst, std::abs(j_.col(j).dot(r_)) / (c * size));
  return worst;
}

Eigen::MatrixXd FitSpace::user_jacobian(const std::vector<double>& b) const {
  Eigen::MatrixXd jacobian = j_;
  for (Index j = 0; j < jacobian.cols(); ++j)
    if (parameter(j).scale == Scale::log) jacobian.col(j) /= b[static_cast<std::size_t>(j)];
  return jacobian;
}

LeastSquaresResult FitSpace::result(const FitEnd& end) const {
  LeastSquaresResult result;
  result.word = end.word;
  result.counters = counters_;
  if (r_.size() == 0) return result;
  const auto free = free_parameters();
  result.sum_of_squares = r_.squaredNorm();
  result.gradient = gradient_cosine(free);
  const auto b = user(t_);
  for (std::size_t j = 0; j < b.size(); ++j) {
    Estimate e;
    e.name = parameters_[j].name;
    e.value = b[j];
    e.at_bound = std::find(free.begin(), free.end(), static_cast<Index>(j)) == free.end();
    result.estimates.push_back(e);
  }
  fit_statistics({user_jacobian(b), r_, free, parameters_, count_}, options_, result);
  // If the residuals are only rounding errors, their direction has no meaning, and the point is optimal.
  const bool exact = r_.norm() <= 1e-13 * size_of_terms(end.cut_short);
  const bool stationary = result.gradient <= 1e-5 || exact;
  result.outcome = stationary      ? Outcome::optimal
                   : end.cut_short ? Outcome::budget
                                   : Outcome::feasible;
  return result;
}

}  // namespace twum::inline v0_1::optim
