// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/solve.hpp>

namespace twum::inline v0_1::optim {

/// The design at a point of the unit cube in user units: each variable mapped by its scale, rounded for an integer
/// variable. For a problem that validate() accepts.
std::vector<double> design_at(const Problem& problem, std::span<const double> unit);

/// Searches for a better local optimum than the one found by local searches. It evaluates `options.scan` designs of a
/// low-discrepancy sequence over the whole range, without derivatives. If one of those that meet every limit improves the
/// answer by more than 1e-6 relative, a search starts from the best of them; else searches start from the best
/// four that have no better one nearby, as in multi level single linkage, unless a single run was enough for the answer. Returns the better answer with Result::scan and the cost of both. If the answer is not feasible or no budget is left, returns it unchanged.
///
/// A sample of n designs misses a basin that fills the share p of the range with probability (1 - p)^n; for 512
/// designs that is one half at p = 0.14 %. So this is no proof of a global optimum.
/// @param found  answer of solve() to this problem with these options
/// @throws what solve() throws
Result look_further(const Problem& problem, const SolveOptions& options, Result found);

}  // namespace twum::inline v0_1::optim
