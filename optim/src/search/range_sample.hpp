// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "problem/session.hpp"

#include <twum/base/function_ref.hpp>

namespace twum::inline v0_1::optim {

/// A design of a sample of the whole range.
struct RangeDesign {
  std::vector<double> place;  ///< in the unit box
  std::vector<double> design;
  Evaluation evaluation;  ///< without derivatives
};

/// Evaluates designs of a low-discrepancy sequence over the whole range, on as many threads as the options say. Those
/// that can be evaluated are seen in the order of the sequence, by one thread at a time, whatever the number of threads.
/// @return its cost: counters, stages and the reason why it ended
Result sample_range(const Problem& problem, const SolveOptions& options, const Deadline& deadline,
                    std::size_t count, FunctionRef<void(RangeDesign&)> see);

}  // namespace twum::inline v0_1::optim
