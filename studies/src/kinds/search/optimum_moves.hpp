// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/result.hpp>
#include <twum/studies/motor_problem.hpp>
#include <twum/studies/optimize_result.hpp>

namespace twum::inline v0_1::studies {

/// Computes the derivatives of an optimum with respect to each parameter that its question holds fixed and that has
/// an influence (L5.2, L5.3), or the reason why there are none. Sets `moving`, `moves`, `unmoved` and
/// `touching` of the result.
/// @param question  with the sets of the optimum in its motor and integer variables fixed; its one goal is not a
///         statistic
/// @param found     an optimum of the question
void add_moves(const DesignProblem& question, const optim::Result& found, OptimizeResult& result);

}  // namespace twum::inline v0_1::studies
