// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "session.hpp"

namespace twum::optim {

/// What the search for causes found and cost.
struct Causes {
  Infeasibility infeasibility;
  Counters counters;
  std::uint64_t stages_used{0};
  StopReason stop{StopReason::finished};
};

/// Evaluations that the search for causes may use: three times what the search has used, of those left.
std::size_t cost_of_causes(const Counters& search, const Budget& budget);

/// Completes the explanation of a problem without a feasible design. Limits that no design keeps,
/// even without all other limits, are separated from limits that only exclude each other; each end of a
/// range that takes part is moved by itself. Every answer is a search of its own from several starts.
/// @param options  of the search that is explained, with first_stage and budget as that search left them
/// @param most  evaluations that this may use
/// @param found  the least infeasible design, with the limits and range ends that meet there
/// @throws what the evaluator throws
Causes find_causes(const Problem& problem, const SolveOptions& options, const Deadline& deadline,
                   std::size_t most, Infeasibility found);

}  // namespace twum::optim
