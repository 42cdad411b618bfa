// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/pareto.hpp>

namespace twum::inline v0_1::optim {

/// True if an integer variable is not fixed by its bounds.
bool has_free_integers(const Problem& problem);

/// The front over all combinations of the integer variables: runs pareto_front() for each of them with an equal share
/// of the remaining budget, and keeps the nondominated points.
/// @throws InputError as pareto_front(), and for more than 64 combinations
Front integer_front(const Problem& problem, const ParetoOptions& options);

}  // namespace twum::inline v0_1::optim
