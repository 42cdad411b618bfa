// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/least_squares.hpp>

#include <span>
#include <vector>

namespace twum::optim {

/// How the answer of a fit moves with numbers that it holds fixed: derivatives of the estimates by each of them (L5.1), from
/// the second derivatives of the sum of squares, which are central differences of its exact gradient. Parameters that a
/// bound holds stay there.
/// @param residuals  of the parameters and then the held numbers, with the Jacobian by all of them
/// @param fit        of these parameters, at an optimum
/// @param held       the held numbers
/// @return rows of one entry a held number, a row for each parameter; NaN where the data do not determine all of the free
///         parameters, or a neighbour cannot be evaluated
/// Cost: two evaluations for each free parameter and each held number.
std::vector<double> answer_moves(const ResidualFunction& residuals, const LeastSquaresResult& fit,
                                 std::span<const double> held);

}  // namespace twum::optim
