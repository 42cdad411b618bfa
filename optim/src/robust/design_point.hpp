// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/inverse_form.hpp"

namespace twum::inline v0_1::optim {

/// The product nearest to the design at which a margin is 0, and its distance.
struct NearestFailure {
  InversePoint point;  ///< converged: the margin is 0 there, and no nearer product is nearby
  double beta{
      0.0};  ///< negative where the design itself breaks the limit; infinite: nothing within 8.2 fails
};

/// Solves G(x, beta) = 0 of U3.2 for beta by Newton's method, U8.1, between a distance at which the margin holds and one at which
/// it fails. Depends on its arguments only. Costs about five solutions of U3.2.
/// @param start  z of a product, nearby in direction and distance; empty: the gradient at the design gives the direction
NearestFailure nearest_failure(const RobustProblem& problem, const Margin& margin,
                               std::span<const double> x, std::span<const double> start);

}  // namespace twum::inline v0_1::optim
