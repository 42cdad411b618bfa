// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "certificate/polish.hpp"

#include <optional>
#include <vector>

namespace twum::test {

/// A stage of its own for a problem scaled at its start.
struct Stage {
  explicit Stage(const optim::Problem& problem, std::size_t quota = 1000)
      : scaling(problem), session(problem, options, deadline, 0, quota) {
    const std::vector<double> start = start_design(problem);
    scaling.scale_responses(start, problem.evaluate(start, true));
  }
  std::optional<std::vector<double>> polished(const std::vector<double>& design,
                                              const std::vector<double>& weights = {1.0}) {
    return polish(session, scaling, design, weights);
  }

  optim::SolveOptions options;
  optim::Deadline deadline{optim::kInfinity};
  optim::Scaling scaling;
  optim::Session session;
};

}  // namespace twum::test
