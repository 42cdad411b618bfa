// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/least_squares.hpp>

#include <Eigen/Core>
#include <string>
#include <vector>

namespace twum::inline v0_1::optim {

/// End of a search for the least sum of squares.
struct FitEnd {
  std::string word;
  bool cut_short{false};  ///< a stop was requested, or the evaluations ran out
};

/// A fit as its solvers see it: residuals as a function of t, the parameters or their logarithms, in a box. Holds the
/// current point and computes the result. Internal.
class FitSpace {
 public:
  FitSpace(const std::vector<Variable>& parameters, const ResidualFunction& residuals,
           const LeastSquaresOptions& options);

  /// Evaluates the start; false if it has no residuals.
  bool start();
  /// Residuals and their Jacobian at t. If there are none, counts the failure by reason and returns false.
  bool evaluate(const Eigen::VectorXd& t, Eigen::VectorXd& r, Eigen::MatrixXd& jacobian);
  /// Makes t the current point.
  void move(const Eigen::VectorXd& t, const Eigen::VectorXd& r, const Eigen::MatrixXd& j);

  const Eigen::VectorXd& t() const { return t_; }
  const Eigen::VectorXd& r() const { return r_; }
  const Eigen::MatrixXd& j() const { return j_; }
  const Eigen::VectorXd& lower() const { return lower_; }
  const Eigen::VectorXd& upper() const { return upper_; }
  const LeastSquaresOptions& options() const { return options_; }
  bool out_of_evaluations() const { return counters_.evaluations >= options_.max_evaluations; }

  /// The parameters that are not held by a bound. A bound holds a parameter if the sum of squares decreases beyond
  /// it.
  std::vector<Eigen::Index> free_parameters() const;
  /// Estimates, intervals and the gradient test at the current point.
  LeastSquaresResult result(const FitEnd& end) const;

 private:
  const Variable& parameter(Eigen::Index j) const {
    return parameters_[static_cast<std::size_t>(j)];
  }
  void set_range_and_start(Eigen::Index j);
  std::vector<double> user(const Eigen::VectorXd& t) const;
  bool to_search_scale(const Residuals& found, const std::vector<double>& b, Eigen::VectorXd& r,
                       Eigen::MatrixXd& jacobian) const;
  bool held(Eigen::Index j) const;
  double size_of_terms(bool cut_short) const;
  double gradient_cosine(const std::vector<Eigen::Index>& free) const;
  Eigen::MatrixXd user_jacobian(const std::vector<double>& b) const;

  const std::vector<Variable>& parameters_;
  const ResidualFunction& function_;
  const LeastSquaresOptions& options_;
  Eigen::VectorXd t_, lower_, upper_, r_;
  Eigen::MatrixXd j_;
  Counters counters_;
  double first_{0.0};     // norm of the residuals at the start
  std::size_t count_{0};  // measured residuals, of which condensed ones are fewer
};

/// GSL's trust region method on the parameters that are not at a bound.
/// @throws InputError if this build lacks GSL
FitEnd gsl_fit(FitSpace& space);
/// Whether GSL is in this build.
bool has_gsl();

}  // namespace twum::inline v0_1::optim
