// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "problem/session.hpp"

namespace twum::inline v0_1::optim {

/// The solvers that auto tries after its starts, in this order, each from the best design so far.
struct Ladder {
  std::vector<std::string> rungs{"nlopt:slsqp", "ipopt", "nlopt:ccsaq", "nlopt:auglag",
                                 "nlopt:sbplx"};
  bool to_the_top{false};  ///< for tests: continues even after a success
};

/// solve() for a problem whose integer variables, if any, are fixed by equal bounds.
Result solve_continuous(const Problem& problem, const SolveOptions& options,
                        const Deadline& deadline, const Ladder& ladder = {});

/// solve() for a valid problem, without the search for causes.
Result solve_plainly(const Problem& problem, const SolveOptions& options, const Deadline& deadline);

}  // namespace twum::inline v0_1::optim
