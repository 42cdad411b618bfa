// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/least_squares.hpp>

#include <cstddef>
#include <limits>
#include <vector>

namespace twum::optim {

/// A residual that chance does not explain.
struct Outlier {
  std::size_t residual{0};  ///< its number
  /// Distance from the fit of the residuals that remain without it, in standard deviations of that distance (L7.1); has the
  /// sign of the residual.
  double distance{0.0};
  /// How often chance puts the farthest of as many residuals at least so far away; 1 at most.
  double p{1.0};
};

/// Residuals that chance does not explain, the farthest first: one after the other is taken out of the linearised fit, so that
/// several do not hide each other (L7.1, L7.2). At most one in ten of the degrees of freedom, and one more.
/// @param at     residuals and Jacobian at the fit's estimates; parameters that a bound holds count as known
/// @param level  how often at least one is found where there is none; more than 0, less than 1
/// @return empty where no scatter is left to compare with: with a known deviation one degree of freedom is needed, else three
/// Cost: m n^2 operations for each residual that is taken out, of m residuals and n parameters.
std::vector<Outlier> find_outliers(const Residuals& at, const LeastSquaresResult& fit,
                                   double deviation = std::numeric_limits<double>::quiet_NaN(),
                                   double level = 0.01);

}  // namespace twum::optim
