// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "session.hpp"

namespace twum::optim {

/// Solves with whole numbers for the integer variables; nothing in between is ever evaluated. Every
/// combination is solved where there are at most 64; otherwise the search goes from the rounded
/// start to the best neighbour, one step of one variable, until no neighbour is better. Where no
/// combination is feasible, the least infeasible one is explained.
Result integer_search(const Problem& problem, const SolveOptions& options,
                      const Deadline& deadline);

}  // namespace twum::optim
