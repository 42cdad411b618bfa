// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "front_search.hpp"
#include "optim/bank/dual_problem.hpp"

#include <functional>
#include <utility>

namespace twum::test {

using D3 = Dual<double, 3>;

/// Variables, what is to be minimized, limits behind that.
inline optim::Problem posed_front(std::vector<optim::Variable> variables, std::size_t objectives,
                                  std::vector<optim::Constraint> constraints,
                                  std::function<void(const D3*, D3*)> f) {
  optim::Problem p;
  p.variables = std::move(variables);
  for (std::size_t k = 0; k < objectives; ++k) p.objectives.push_back({numbered('f', k)});
  p.constraints = std::move(constraints);
  p.evaluate = dual_evaluator<3>(p.responses(), std::move(f));
  return p;
}

/// A search for a front of a problem, scaled at its start.
struct ScaledSearch {
  explicit ScaledSearch(optim::Problem p) : problem(std::move(p)) { front.campaign().scale(); }

  std::vector<double> start() { return front.campaign().unit_start(); }
  std::size_t calls() { return front.campaign().counters().evaluations; }

  optim::Problem problem;
  optim::SolveOptions solve;
  optim::ParetoOptions options;
  optim::Deadline deadline{optim::kInfinity};
  optim::FrontSearch front{problem, solve, options, deadline};
};

}  // namespace twum::test
