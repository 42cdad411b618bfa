// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/result.hpp>
#include <twum/optim/solvers.hpp>

#include <limits>

namespace twum::inline v0_1::optim {

/// Residuals r_i(b) of a fit, already weighted, and their Jacobian.
struct Residuals {
  std::vector<double> values{};    ///< in units of the weights
  std::vector<double> jacobian{};  ///< values.size() rows of one entry a parameter
  std::string failure{};           ///< short reason; empty: it worked
  std::size_t stand_for{0};        ///< residuals that condensed ones stand for; 0: themselves

  /// Number of measured residuals.
  std::size_t count() const noexcept { return stand_for > 0 ? stand_for : values.size(); }
};

/// At most one residual more than there are parameters, with the same sum of squares and the same products J^T r and J^T J
/// but for rounding: [J r] = Q [R q], of which R and q are kept (L1.2). To a fit of squares they are the same residuals. Cost:
/// m (n + 1)^2 operations for m residuals of n parameters.
Residuals condensed(const Residuals& residuals);

/// Parameters in user units; fixed size of the answer. May throw EvaluationError for a failure.
using ResidualFunction = std::function<Residuals(std::span<const double> parameters)>;

/// Names of the solvers of fits.
/// @{
inline constexpr const char* kOwnFit = "twum:lm";
inline constexpr const char* kGslFit = "gsl:lm";
/// @}

/// How residuals count.
enum class Loss : unsigned char {
  squares,  ///< by their squares
  huber  ///< beyond 1.345 standard deviations by their size, so that a few that are far off move the fit little
};
/// As in a study; static lifetime.
const char* to_string(Loss value) noexcept;

/// What groups of residuals with a scatter of their own make of the interval of one parameter (L9.2, L9.3).
struct SmallSample {
  double freedom{0.0};   ///< degrees of freedom that its standard deviation is known to
  double widening{1.0};  ///< factor on the linearised standard deviation
  double quantile{0.0};  ///< half width of its interval in these standard deviations; 0: Student's
};

/// How to fit.
struct LeastSquaresOptions {
  std::string solver{kOwnFit};        ///< one of least_squares_solvers()
  Loss loss{Loss::squares};           ///< what is the least
  std::size_t max_evaluations{2000};  ///< calls of the residuals
  double tolerance{
      1e-13};  ///< relative decrease of the sum of squares, and step, that end the search
  double confidence{0.95};  ///< of the intervals
  double rank_tolerance{
      1e-10};  ///< relative singular value below which a combination is undetermined
  /// Standard deviation of every residual where it is known, in units of the weights, more than 0; NaN: it is estimated
  /// from the residuals.
  double deviation{std::numeric_limits<double>::quiet_NaN()};
  /// Of each parameter, where the residuals are in parts of estimated deviations of groups; empty: one scatter, known to
  /// residuals less parameters.
  std::vector<SmallSample> small_sample{};
  std::stop_token stop{};  ///< a request ends the search with what has been found
};

/// What a fit says of one parameter, in user units.
struct Estimate {
  std::string name{};              ///< of the parameter
  double value{0.0};               ///< at the least sum of squares
  double standard_deviation{0.0};  ///< NaN if the data do not determine it
  double low{
      0.0};  ///< lower end of the confidence interval (Student's t; of the logarithm on a log scale), or NaN
  double high{0.0};      ///< its other end
  bool at_bound{false};  ///< held by a bound: then it counts as known
  double rise{0.0};      ///< root of the rise of the sum of squares where the interval ends (L3.1)
};

/// A change of the parameters together, and how much of it the residuals show, to first order (L2.3).
struct Direction {
  /// Of each parameter in parts of its value (of its range where the value is 0); the largest is 1. 0 for held ones.
  std::vector<double> change{};
  std::vector<double>
      part_norms;  ///< for each parameter: norm of the change of the residuals if only this one changes
  double effect{0.0};  ///< norm of the change of the residuals if all change together
};

/// What a fit has found.
struct LeastSquaresResult {
  /// optimal: the gradient test passes, and a scatter that is estimated in turn with the parameters has settled
  Outcome outcome{Outcome::failed};
  std::vector<Estimate> estimates{};  ///< in the order of the parameters
  std::vector<double> correlation{};  ///< parameters x parameters; NaN where undetermined
  std::vector<double> covariance{};   ///< likewise; 0 for parameters held by a bound
  double sum_of_squares{0.0};         ///< of the residuals; of Huber's, twice the loss over `share`
  double residual_deviation{0.0};     ///< sqrt(sum / degrees of freedom); NaN without freedom
  std::size_t degrees_of_freedom{0};  ///< residuals less free parameters
  /// Standard deviation of a residual that gives the width of the intervals: the known one, else the estimated one.
  double scatter{0.0};
  bool scatter_known{false};  ///< it was given
  /// Size of residual beyond which it counts linearly (L8.1), and the part of the residuals within it.
  /// @{
  double bend{kInfinity};
  double share{1.0};
  /// @}
  /// Half width of an interval in deviations: Student's t, or of the normal law if the scatter is known; the largest, where
  /// groups have a scatter of their own; NaN likewise.
  double student_t{0.0};
  /// Largest sum of squares in the joint confidence region of all free parameters (L2.2); NaN likewise.
  double joint_limit{0.0};
  /// Parameters x parameters: by how much a free one (row) changes for each unit by which the bound of
  /// a held one (column) moves, to first order; 0 elsewhere, NaN where undetermined.
  std::vector<double> follows{};
  double gradient{0.0};  ///< largest cosine between the residuals and a free Jacobian column
  std::size_t rank{0};   ///< of the Jacobian in the free parameters
  std::vector<std::vector<std::string>>
      undetermined;  ///< each a set of parameters that only counts together
  /// Directions in the free parameters, orthogonal in relative changes, the least visible first (L2.3).
  std::vector<Direction> directions{};
  Counters counters{};  ///< calls of the residuals
  std::string word{};   ///< how the search ended
};

/// The solvers of fits, those that this build lacks included: "twum:lm", Levenberg and Marquardt's method that
/// projects onto the bounds, and "gsl:lm", GSL's trust region method on the parameters that are not at a bound.
const std::vector<SolverInfo>& least_squares_solvers();

/// Fits parameters within bounds by least squares; log scales are fitted in the logarithm, and linear systems are
/// solved by QR. Whatever the solver, the answer is judged by the same gradient test. The covariance is
/// s^2 (J^T J)^-1 at the optimum over the parameters that no bound holds; intervals are
/// linearised (L2.1); profile_end() says how far they are to be believed. A failed evaluation shortens the step.
/// Variables without a start begin in the middle; bounds may be infinite where a start is given and
/// the scale is linear.
/// The residuals should be smooth in the parameters. Local: other starts may find other optima. Safe from
/// any number of threads if the residuals are. Cost: one evaluation a step, and m n^2 operations for m
/// residuals of n parameters. Under Huber's loss parameters and scatter are estimated in turn, about ten fits; covariance and
/// intervals are those of (L8.3). If they do not settle in 60 rounds the outcome is feasible, and the word says so.
/// @throws InputError for an unknown solver or one that this build lacks, for no parameters, names missing or twice, fewer residuals than free
///         parameters, a start without a value
LeastSquaresResult least_squares(const std::vector<Variable>& parameters,
                                 const ResidualFunction& residuals,
                                 const LeastSquaresOptions& options = {});

}  // namespace twum::inline v0_1::optim
