// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/least_squares.hpp>

#include <cstddef>
#include <vector>

namespace twum::optim {

/// Which end of an interval.
enum class IntervalEnd : unsigned char { low, high };

/// An end of the confidence interval of one parameter.
struct ProfileEnd {
  double value{0.0};  ///< in user units, inside the parameter's bounds
  bool linear{
      false};  ///< the linearised end: the profile agrees with it to a tenth of the half width
  bool cut_off{false};  ///< the bound stands there: the data allow values beyond it
  /// Parameters met on the way with a sum of squares less than that of the fit, which is then not the least; empty: none.
  std::vector<double> better;
};

/// The end of a confidence interval by the profile of the sum of squares (L3.1): where its least value with this parameter
/// held, the others free, exceeds that of the fit by (t s)^2. Where the linearised end agrees, that stands. No value beyond the
/// bounds is asked for. Parameters that a bound holds in the fit stay there.
/// Cost: one constrained fit of the others where the linearised end agrees, else about ten.
/// @param fit        of these parameters and residuals, with these options
/// @param parameter  number of one that no bound holds, and with a finite standard deviation above 0
ProfileEnd profile_end(const std::vector<Variable>& parameters, const ResidualFunction& residuals,
                       const LeastSquaresOptions& options, const LeastSquaresResult& fit,
                       std::size_t parameter, IntervalEnd end);

}  // namespace twum::optim
