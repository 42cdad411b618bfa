// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/solve.hpp>

namespace twum::inline v0_1::studies {

/// optim::solve() with several starts also for a local solver chosen by name: the best of `options.starts` runs, the
/// first from the problem's start, the others from a low-discrepancy sequence, within one budget. Of answers that are
/// equal within the solvers' accuracy the first is taken. Then optim::look_further() searches for a better local
/// optimum.
optim::Result solve_from_starts(const optim::Problem& problem, const optim::SolveOptions& options);

}  // namespace twum::inline v0_1::studies
