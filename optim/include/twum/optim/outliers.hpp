// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/least_squares.hpp>

#include <cstddef>
#include <limits>
#include <vector>

namespace twum::inline v0_1::optim {

/// A residual that chance does not explain.
struct Outlier {
  std::size_t residual{0};  ///< its index
  /// Distance from a fit to the remaining residuals without this one, in standard deviations of that distance (L7.1).
  /// Has the sign of the residual.
  double distance{0.0};
  /// Probability that the farthest of as many residuals is at least this far away by chance; at most 1.
  double p{1.0};
};

/// Finds residuals that chance does not explain, the farthest first. They are removed from the linearised fit one
/// after the other, so that several outliers cannot hide each other (L7.1, L7.2). Removes at most a tenth of the
/// degrees of freedom plus one.
/// @param at     residuals and Jacobian at the fit's estimates; parameters at a bound count as known
/// @param level  probability of finding at least one where there is none; more than 0, less than 1
/// @return empty if there are too few degrees of freedom to estimate the scatter: one is needed with a known
///         deviation, else three Cost: m n^2 operations for each residual removed, with m residuals and n parameters.
std::vector<Outlier> find_outliers(const Residuals& at, const LeastSquaresResult& fit,
                                   double deviation = std::numeric_limits<double>::quiet_NaN(),
                                   double level = 0.01);

}  // namespace twum::inline v0_1::optim
