// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/certify.hpp>
#include <twum/optim/result.hpp>

namespace twum::inline v0_1::optim {

/// Solves a problem with one objective.
///
/// All solvers work on the same scaled problem and share one archive, so the answer is the best feasible design that
/// was evaluated, whatever a solver returns. It is certified from exact gradients. If the certificate fails with
/// solver "auto", the next solver of a fixed sequence is tried. The answer depends on problem, options and seed, not
/// on the number of threads, unless the budget limits the seconds. May be called from any number of threads if the
/// evaluator may, and from an evaluator. One solve at a time computes within Ipopt; the others evaluate meanwhile, or wait.
/// Cost: some hundred to some thousand evaluations; everything else is small.
///
/// @throws InputError if validate() refuses the problem or the options, for a solver that does not exist or does not fit the
///         problem, an unknown option; and whatever else the evaluator throws.
Result solve(const Problem& problem, const SolveOptions& options = {});

}  // namespace twum::inline v0_1::optim
