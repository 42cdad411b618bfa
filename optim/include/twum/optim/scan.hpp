// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/solve.hpp>

namespace twum::optim {

/// The design at a point of the unit cube, user units: each variable on its scale, rounded where only whole numbers will
/// do. For a problem that validate() accepts.
std::vector<double> design_at(const Problem& problem, std::span<const double> unit);

/// Looks for a better valley than the one that local searches have ended in: evaluates `options.scan` designs of a
/// low-discrepancy sequence over the whole range, without derivatives, and starts a search at the best of those that keep
/// every limit and beat the answer by more than 1e-6 of itself. The answer is the better one, with Result::scan and the cost
/// of both. An answer that is not feasible, or for which no budget is left, is returned as it is.
///
/// A sample of n designs misses valleys that fill a part p of the range with the probability (1 - p)^n: of 512 designs, one
/// half for p = 0.14 %. It proves nothing; a certified optimum remains a local one.
/// @param found  answer of solve() to this problem with these options
/// @throws what solve() throws
Result look_further(const Problem& problem, const SolveOptions& options, Result found);

}  // namespace twum::optim
