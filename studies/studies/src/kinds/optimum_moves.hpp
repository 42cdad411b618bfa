// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/result.hpp>
#include <twum/studies/problem/motor_problem.hpp>
#include <twum/studies/results/optimize_result.hpp>

namespace twum::studies {

/// Fills how an optimum moves with each parameter of the motor that its question holds fixed and that counts there (L5.2,
/// L5.3), or why that cannot be said: `moving`, `moves` and `unmoved` of the result.
/// @param question  with the sets of the optimum in its motor and the whole numbers held; one goal that is no statistic
/// @param found     an optimum of it
void add_moves(const DesignProblem& question, const optim::Result& found, OptimizeResult& result);

}  // namespace twum::studies
