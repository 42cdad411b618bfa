// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/result.hpp>

namespace twum::optim {

/// Residuals r_i(b) of a fit, already weighted, and their Jacobian.
struct Residuals {
  std::vector<double> values;
  std::vector<double> jacobian;  ///< values.size() rows of one entry a parameter
  std::string failure;           ///< short reason; empty: it worked
};

/// Parameters in user units; fixed size of the answer. May throw EvaluationError for a failure.
using ResidualFunction = std::function<Residuals(std::span<const double> parameters)>;

struct LeastSquaresOptions {
  std::size_t max_evaluations{2000};
  double tolerance{
      1e-13};  ///< relative decrease of the sum of squares, and step, that end the search
  double confidence{0.95};  ///< of the intervals
  double rank_tolerance{
      1e-10};  ///< relative singular value below which a combination is undetermined
  std::stop_token stop;
};

struct Estimate {
  std::string name;
  double value{0.0};
  double standard_deviation{0.0};  ///< NaN if the data do not determine it
  double low{0.0};                 ///< confidence interval, Student's t; NaN likewise
  double high{0.0};
  bool at_bound{false};  ///< held by a bound: then it counts as known
};

struct LeastSquaresResult {
  Outcome outcome{Outcome::failed};  ///< optimal: the gradient test passes
  std::vector<Estimate> estimates;
  std::vector<double> correlation;  ///< parameters x parameters; NaN where undetermined
  std::vector<double> covariance;
  double sum_of_squares{0.0};
  double residual_deviation{0.0};  ///< sqrt(sum / degrees of freedom); NaN without freedom
  std::size_t degrees_of_freedom{0};
  double gradient{0.0};  ///< largest cosine between the residuals and a free Jacobian column
  std::size_t rank{0};   ///< of the Jacobian in the free parameters
  std::vector<std::vector<std::string>>
      undetermined;  ///< each a set of parameters that only counts together
  Counters counters;
  std::string word;  ///< how the search ended
};

/// Fits parameters within bounds by least squares: a Levenberg-Marquardt method that projects onto
/// the bounds (log scales are fitted in the logarithm), QR throughout. The covariance is
/// s^2 (J^T J)^-1 at the optimum over the parameters that no bound holds; intervals are
/// linearised. A failed evaluation shortens the step.
/// Variables without a start begin in the middle; bounds may be infinite where a start is given and
/// the scale is linear.
/// @throws InputError for no parameters, names missing or twice, fewer residuals than free
///         parameters, a start without a value
LeastSquaresResult least_squares(const std::vector<Variable>& parameters,
                                 const ResidualFunction& residuals,
                                 const LeastSquaresOptions& options = {});

}  // namespace twum::optim
