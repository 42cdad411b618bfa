// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/least_squares.hpp>

#include <cstddef>
#include <vector>

namespace twum::inline v0_1::optim {

/// Whether neighbouring residuals of a fit are more alike than chance makes them (L4.1).
struct NeighbourTest {
  std::size_t count{0};     ///< residuals that have a neighbour
  double correlation{0.0};  ///< of neighbours, -1 to 1
  /// Probability that independent normal errors of one size give so small a ratio, or a smaller one, after the same fit; 1
  /// where nothing can be said.
  double p{1.0};
};

/// Tests the squared differences of neighbouring residuals against their squares (Durbin and Watson 1971). The residuals are
/// those of a linear fit with this Jacobian: where some points of the fit are left out, of one to the others.
/// @param at      residuals and Jacobian at the fit's estimates; parameters at a bound count as known
/// @param series  numbers of residuals in the order of what was varied; neighbours are next to each other in one series
/// @return p to 1e-10; with more than 300 residuals to a few per cent of itself
/// Cost: the cube of the number of residuals up to 300 of them.
NeighbourTest neighbour_test(const Residuals& at, const LeastSquaresResult& fit,
                             const std::vector<std::vector<std::size_t>>& series);

}  // namespace twum::inline v0_1::optim
