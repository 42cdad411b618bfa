// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/result.hpp>

namespace twum::optim {

/// Solves a problem with one objective.
///
/// Every solver works on the same scaled problem and shares one archive, so the answer is the best
/// feasible design seen, whatever the solver returned. It is certified from exact gradients; with
/// solver "auto" a failed certificate leads to the next solver of a ladder. The answer follows from
/// problem, options and seed, for any number of threads; a finite budget of seconds apart. Safe from
/// any number of threads if the evaluator is; solves by Ipopt take turns. Cost: some hundred to some
/// thousand evaluations, beside which everything else is small.
///
/// @throws InputError for a problem that cannot be posed, a solver that does not exist or does
///         not fit the problem, an unknown option; and whatever else the evaluator throws.
Result solve(const Problem& problem, const SolveOptions& options = {});

}  // namespace twum::optim
