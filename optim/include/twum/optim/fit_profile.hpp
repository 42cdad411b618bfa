// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/least_squares.hpp>

#include <cstddef>
#include <vector>

namespace twum::inline v0_1::optim {

/// Which end of an interval.
enum class IntervalEnd : unsigned char { low, high };
/// "low" or "high"; static lifetime.
const char* to_string(IntervalEnd value) noexcept;

/// A point of a profile: z^2 is the rise of the least sum of squares in parts of that at the end of the interval (L3.1).
struct ProfilePoint {
  double value{0.0};  ///< of the parameter, in user units
  double z{0.0};      ///< negative below the estimate; -1 and 1 at the ends of the interval
  double slope{0.0};  ///< dz/dvalue
};

/// An end of the confidence interval of one parameter.
struct ProfileEnd {
  double value{0.0};  ///< in user units, inside the parameter's bounds
  /// the linearised end was taken: the profile agrees with it to a tenth of the half width
  bool linear{false};
  bool cut_off{false};  ///< the interval is cut off by the bound; the data allow values beyond it
  /// Parameters found on the way whose sum of squares is less than that of the fit, which is then not the minimum;
  /// empty if there are none.
  std::vector<double> better;
  std::vector<ProfilePoint> points{};  ///< of the profile that were met, from the least value on
};

/// The end of a confidence interval from the profile of the sum of squares (L3.1). The profile is the least sum of
/// squares over the other parameters for a given value of this one. At the end it exceeds the sum of the fit by (t
/// s)^2. If the linearised end agrees, it is taken. No value beyond the bounds is evaluated, and parameters that are
/// at a bound in the fit stay there. Cost: one constrained fit of the others where the linearised end agrees, else
/// about ten. Where the Jacobian of the fit lacks rank, there is no linearised end, and the search begins at a hundredth of
/// the range.
/// @param fit        of these parameters and residuals, with these options
/// @param parameter  index of a parameter that is not at a bound and whose `rise` is finite and above 0
ProfileEnd profile_end(const std::vector<Variable>& parameters, const ResidualFunction& residuals,
                       const LeastSquaresOptions& options, const LeastSquaresResult& fit,
                       std::size_t parameter, IntervalEnd end);

}  // namespace twum::inline v0_1::optim
