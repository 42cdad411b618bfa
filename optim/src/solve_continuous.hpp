// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "session.hpp"

namespace twum::optim {

/// solve() for a problem whose integer variables, if any, are fixed by equal bounds.
Result solve_continuous(const Problem& problem, const SolveOptions& options,
                        const Deadline& deadline);

}  // namespace twum::optim
