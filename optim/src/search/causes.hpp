// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "problem/session.hpp"

namespace twum::inline v0_1::optim {

/// Result and cost of the search for causes.
struct Causes {
  Infeasibility infeasibility;
  std::vector<double>
      feasible;  ///< a design that keeps every limit, user units, if one was found all the same
  Counters counters;
  std::uint64_t stages_used{0};
  StopReason stop{StopReason::finished};
};

/// Evaluations that the search for causes may use: three times those that the search has used, at most those that are
/// left.
std::size_t cost_of_causes(const Counters& search, const Budget& budget);

/// Completes the explanation of a problem without a feasible design. Separates limits that no design meets, even
/// without all other limits, from limits that only exclude each other. Moves each end of a range that contributes on
/// its own. Each answer is a separate search from several starts.
/// @param options  of the search that is explained, with first_stage and budget as that search left them
/// @param most  evaluations that the search for causes may use
/// @param found  the least infeasible design, with the limits and range ends that are active there
/// @throws what the evaluator throws
Causes find_causes(const Problem& problem, const SolveOptions& options, const Deadline& deadline,
                   std::size_t most, Infeasibility found);

}  // namespace twum::inline v0_1::optim
