// SPDX-License-Identifier: Apache-2.0
#include <twum/optim/least_squares.hpp>

#include <twum/base/error.hpp>

#include "fit_statistics.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace twum::optim {
namespace {

using Eigen::Index;

// The search runs in t: the parameter itself, or its logarithm.
class Fit {
 public:
  Fit(const std::vector<Variable>& parameters, const ResidualFunction& residuals,
      const LeastSquaresOptions& options)
      : parameters_(parameters), function_(residuals), options_(options) {
    const Index n = static_cast<Index>(parameters.size());
    t_.resize(n);
    lower_.resize(n);
    upper_.resize(n);
    for (Index j = 0; j < n; ++j) begin(j);
  }

  LeastSquaresResult run() {
    LeastSquaresResult result;
    if (evaluate(t_, r_, j_)) {
      first_ = r_.norm();
      result.word = iterate();
      describe(result);
    } else {
      result.word = "the start cannot be evaluated";
    }
    result.counters = counters_;
    return result;
  }

 private:
  const Variable& parameter(Index j) const { return parameters_[static_cast<std::size_t>(j)]; }

  void begin(Index j) {
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

  std::vector<double> user(const Eigen::VectorXd& t) const {
    std::vector<double> b;
    for (Index j = 0; j < t.size(); ++j) {
      const Variable& v = parameter(j);
      b.push_back(std::clamp(v.scale == Scale::log ? std::exp(t[j]) : t[j], v.lower, v.upper));
    }
    return b;
  }

  bool evaluate(const Eigen::VectorXd& t, Eigen::VectorXd& r, Eigen::MatrixXd& jacobian) {
    const auto b = user(t);
    ++counters_.evaluations;
    ++counters_.gradients;
    Residuals found;
    try {
      found = function_(b);
    } catch (const EvaluationError& e) {
      found.failure = e.reason();
    }
    if (found.failure.empty() && !take(found, b, r, jacobian)) found.failure = "not-finite";
    if (!found.failure.empty()) ++counters_.failures[found.failure];
    return found.failure.empty();
  }

  bool take(const Residuals& found, const std::vector<double>& b, Eigen::VectorXd& r,
            Eigen::MatrixXd& jacobian) const {
    const Index m = static_cast<Index>(found.values.size());
    const Index n = t_.size();
    if (found.jacobian.size() != found.values.size() * b.size())
      throw InputError("least squares: the Jacobian has the wrong size");
    if (m < n - (lower_.array() == upper_.array()).count())
      throw InputError("least squares: there are fewer residuals than free parameters");
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    r = Eigen::Map<const Eigen::VectorXd>(found.values.data(), m);
    jacobian = Eigen::Map<const RowMajor>(found.jacobian.data(), m, n);
    for (Index j = 0; j < n; ++j)
      if (parameter(j).scale == Scale::log) jacobian.col(j) *= b[static_cast<std::size_t>(j)];
    return r.allFinite() && jacobian.allFinite();
  }

  // Held: at a bound, with the sum of squares falling beyond it.
  bool held(Index j) const {
    if (lower_[j] == upper_[j]) return true;
    const double slope = j_.col(j).dot(r_);
    return (t_[j] <= lower_[j] && slope >= 0.0) || (t_[j] >= upper_[j] && slope <= 0.0);
  }

  std::vector<Index> free_parameters() const {
    std::vector<Index> free;
    for (Index j = 0; j < t_.size(); ++j)
      if (!held(j)) free.push_back(j);
    return free;
  }

  // min |J d + r|^2 + damping |D d|^2 by QR of the stacked matrix.
  Eigen::VectorXd step(const std::vector<Index>& free, double damping) const {
    const Index k = static_cast<Index>(free.size());
    const Index m = r_.size();
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(m + k, k);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(m + k);
    b.head(m) = -r_;
    for (Index i = 0; i < k; ++i) {
      const Index j = free[static_cast<std::size_t>(i)];
      a.block(0, i, m, 1) = j_.col(j) / scale_[j];
      a(m + i, i) = std::sqrt(damping);
    }
    const Eigen::VectorXd y = a.colPivHouseholderQr().solve(b);
    Eigen::VectorXd d = Eigen::VectorXd::Zero(t_.size());
    for (Index i = 0; i < k; ++i) {
      const Index j = free[static_cast<std::size_t>(i)];
      d[j] = y[i] / scale_[j];
    }
    return d;
  }

  // Column norms, never shrinking (More 1978): the method is then blind to the parameters' units.
  void update_scale() {
    if (scale_.size() == 0) scale_ = Eigen::VectorXd::Zero(t_.size());
    for (Index j = 0; j < t_.size(); ++j) scale_[j] = std::max(scale_[j], j_.col(j).norm());
    for (Index j = 0; j < t_.size(); ++j)
      if (scale_[j] == 0.0) scale_[j] = 1.0;
  }

  // Says why it ended.
  const char* iterate() {
    double damping = 1e-3;
    double growth = 2.0;
    int small = 0;
    while (true) {
      if (options_.stop.stop_requested()) return cut_short("stopped on request");
      if (counters_.evaluations >= options_.max_evaluations)
        return cut_short("too many evaluations");
      update_scale();
      const auto free = free_parameters();
      if (free.empty()) return "every parameter is held by a bound";
      const Eigen::VectorXd d = step(free, damping);
      const Eigen::VectorXd next = (t_ + d).cwiseMax(lower_).cwiseMin(upper_);
      const Eigen::VectorXd moved = next - t_;
      if (moved.cwiseProduct(scale_).norm() <= 1e-16 * t_.cwiseProduct(scale_).norm())
        return "no step changes the parameters";
      Eigen::VectorXd r;
      Eigen::MatrixXd jacobian;
      const double before = r_.squaredNorm();
      const bool ok = evaluate(next, r, jacobian);
      const double after = ok ? r.squaredNorm() : kInfinity;
      const double predicted = before - (r_ + j_ * moved).squaredNorm();
      const double ratio = predicted > 0.0 ? (before - after) / predicted : -1.0;
      if (ok && after <= before && (ratio > 1e-4 || predicted <= 1e-13 * before)) {
        const bool tiny =
            before - after <= options_.tolerance * before &&
            moved.cwiseProduct(scale_).norm() <= 1e-9 * (t_.cwiseProduct(scale_).norm() + 1e-300);
        t_ = next;
        r_ = r;
        j_ = jacobian;
        damping *= std::max(1.0 / 5.0, 1.0 - std::pow(2.0 * ratio - 1.0, 3));
        damping = std::max(damping, 1e-30);
        growth = 2.0;
        small = tiny ? small + 1 : 0;
        if (small >= 3 || after == 0.0) return "converged";
      } else {
        damping *= growth;
        growth *= 2.0;
        if (damping > 1e30) return "no step lowers the sum of squares";
      }
    }
  }

  const char* cut_short(const char* word) {
    cut_short_ = true;
    return word;
  }

  // What the residuals are a difference of, as far as that is known: the terms of their linear part and, if the
  // search has gone as far as it could, what they were at first.
  double size_of_terms() const {
    double size = cut_short_ ? 0.0 : first_;
    for (Index j = 0; j < t_.size(); ++j)
      size += j_.col(j).norm() * (parameter(j).scale == Scale::log ? 1.0 : std::abs(t_[j]));
    return size;
  }

  // Cosine between residuals and columns: zero at an optimum, whatever the units.
  double gradient_cosine(const std::vector<Index>& free) const {
    double worst = 0.0;
    const double size = r_.norm();
    for (const Index j : free)
      if (const double c = j_.col(j).norm(); c > 0.0 && size > 0.0)
        worst = std::max(worst, std::abs(j_.col(j).dot(r_)) / (c * size));
    return worst;
  }

  Eigen::MatrixXd user_jacobian(const std::vector<double>& b) const {
    Eigen::MatrixXd jacobian = j_;
    for (Index j = 0; j < jacobian.cols(); ++j)
      if (parameter(j).scale == Scale::log) jacobian.col(j) /= b[static_cast<std::size_t>(j)];
    return jacobian;
  }

  void describe(LeastSquaresResult& result) {
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
    fit_statistics({user_jacobian(b), r_, free, parameters_}, options_, result);
    // Where the residuals vanish to rounding their direction means nothing, and zero is optimal.
    const bool exact = r_.norm() <= 1e-13 * size_of_terms();
    const bool stationary = result.gradient <= 1e-5 || exact;
    result.outcome = stationary   ? Outcome::optimal
                     : cut_short_ ? Outcome::budget
                                  : Outcome::feasible;
  }

  const std::vector<Variable>& parameters_;
  const ResidualFunction& function_;
  const LeastSquaresOptions& options_;
  Eigen::VectorXd t_, lower_, upper_, scale_, r_;
  Eigen::MatrixXd j_;
  Counters counters_;
  double first_{0.0};  // norm of the residuals at the start
  bool cut_short_{false};
};

}  // namespace

LeastSquaresResult least_squares(const std::vector<Variable>& parameters,
                                 const ResidualFunction& residuals,
                                 const LeastSquaresOptions& options) {
  if (parameters.empty()) throw InputError("least squares: there is no parameter");
  for (std::size_t j = 0; j < parameters.size(); ++j)
    for (std::size_t i = 0; i <= j; ++i)
      if (parameters[j].name.empty() || (i < j && parameters[i].name == parameters[j].name))
        throw InputError("parameter '" + parameters[j].name +
                         "': the name is empty or there twice");
  return Fit(parameters, residuals, options).run();
}

}  // namespace twum::optim
