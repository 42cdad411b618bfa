// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/least_squares.hpp>

#include <span>
#include <vector>

namespace twum::inline v0_1::optim {

/// Derivatives of a fit's estimates with respect to numbers that the fit holds fixed (L5.1). They follow from the
/// second derivatives of the sum of squares, which are central differences of its exact gradient. Parameters at a
/// bound stay there.
/// @param residuals  a function of the parameters followed by the held numbers, with the Jacobian with respect to all
///         of them
/// @param fit        fit of these parameters, at an optimum
/// @param held       the held numbers
/// @return one row for each parameter with one entry for each held number; NaN where the data do not determine all
///         free parameters, or a point of a difference cannot be evaluated
/// Cost: two evaluations for each free parameter and each held number.
std::vector<double> answer_moves(const ResidualFunction& residuals, const LeastSquaresResult& fit,
                                 std::span<const double> held);

}  // namespace twum::inline v0_1::optim
