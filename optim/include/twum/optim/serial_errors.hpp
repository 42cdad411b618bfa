// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/least_squares.hpp>

#include <cstddef>
#include <vector>

namespace twum::inline v0_1::optim {

/// What errors that follow each other in series make of the intervals of a fit (section 10 of the theory of calibration).
struct SerialErrors {
  /// The likeliest correlation of neighbours by (L10.2), 0 to 0.98; 0 where the residuals show none.
  double correlation{0.0};
  /// Of each parameter, for LeastSquaresOptions; empty: the intervals stand.
  std::vector<SmallSample> small_sample{};
};

/// Widens the intervals of a fit whose scatter is estimated, unless its residuals are as unlike as independent errors are: where
/// chance puts neighbours as much alike with 30 % or more (L4.1), nothing changes.
/// @param at      residuals and Jacobian at the fit's estimates
/// @param series  numbers of residuals in the order of what was varied
/// Cost: that of neighbour_test(), and 50 m n^2 operations for m residuals of n parameters.
SerialErrors serial_errors(const Residuals& at, const LeastSquaresResult& fit,
                           const std::vector<std::vector<std::size_t>>& series, double confidence);

}  // namespace twum::inline v0_1::optim
