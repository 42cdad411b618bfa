// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fronts/front_search.hpp"
#include "optim/bank/posed.hpp"

#include <utility>

namespace twum::test {

using D3 = Dual<double, 3>;

/// A search for a front of a problem, scaled at its start.
struct ScaledSearch {
  explicit ScaledSearch(optim::Problem p) : problem(std::move(p)) { front.runner().scale(); }

  std::vector<double> start() { return front.runner().unit_start(); }
  std::size_t calls() { return front.runner().counters().evaluations; }

  optim::Problem problem;
  optim::SolveOptions solve;
  optim::ParetoOptions options;
  optim::Deadline deadline{optim::kInfinity};
  optim::FrontSearch front{problem, solve, options, deadline};
};

}  // namespace twum::test
