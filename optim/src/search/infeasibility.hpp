// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "search/stage_runner.hpp"

namespace twum::inline v0_1::optim {

/// Searches for a feasible design, or for the least infeasible one, by an elastic solve: each limit may be violated
/// at a penalty. Returns the best design in the unit box; nothing if no run has evaluated a design. @throws what the
/// evaluator throws
std::optional<Candidate> elastic_search(StageRunner& runner,
                                        const std::vector<std::vector<double>>& starts);

/// Why a problem has no feasible design, unless a feasible one was found on the way.
struct Explanation {
  Infeasibility report;
  std::vector<double>
      feasible;  ///< a design that keeps every limit, user units; empty: none was found
};

/// Explains a problem without a feasible design, at the least infeasible one.
Explanation explain_infeasible(StageRunner& runner, std::span<const double> unit);

}  // namespace twum::inline v0_1::optim
