// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "problem/session.hpp"

namespace twum::inline v0_1::optim {

/// Solves a problem with integer variables, which are never evaluated at fractions. If there are at most 64
/// combinations, each is solved. Otherwise the search moves from the rounded start to the best neighbour, one step of
/// one variable at a time, until no neighbour is better. If no combination is feasible, the least infeasible one is
/// explained.
Result integer_search(const Problem& problem, const SolveOptions& options,
                      const Deadline& deadline);

}  // namespace twum::inline v0_1::optim
