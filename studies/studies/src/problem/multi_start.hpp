// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/solve.hpp>

namespace twum::studies {

/// optim::solve(), and for a local solver with a name the best of `options.starts` runs as well: the
/// first from the problem's start, the others from a low-discrepancy sequence, within one budget. Of
/// answers that are equal up to the solvers' accuracy the first counts. Then optim::look_further() looks for a better valley.
optim::Result solve_from_starts(const optim::Problem& problem, const optim::SolveOptions& options);

}  // namespace twum::studies
