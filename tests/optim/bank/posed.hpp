// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "optim/bank/dual_problem.hpp"

#include <utility>

namespace twum::test {

/// A problem of at most N variables with exact slopes: f(x, out) puts the objectives, and behind them what
/// the constraints limit, into `out`.
template <int N, typename F>
optim::Problem posed(std::vector<optim::Variable> variables,
                     std::vector<optim::Constraint> constraints, F f, std::size_t objectives = 1) {
  optim::Problem p;
  p.variables = std::move(variables);
  for (std::size_t k = 0; k < objectives; ++k) p.objectives.push_back({numbered('f', k)});
  p.constraints = std::move(constraints);
  p.evaluate = dual_evaluator<N>(p.responses(), std::move(f));
  return p;
}

}  // namespace twum::test
