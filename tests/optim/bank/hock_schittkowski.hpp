// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/problem.hpp>

namespace twum::test {

/// A problem that knows its best value.
struct KnownProblem {
  std::string name;
  optim::Problem problem;
  double best{0.0};
  bool equalities{false};
};

/// Problems of W. Hock and K. Schittkowski, Test Examples for Nonlinear Programming Codes (1981),
/// with the values published there. Variables without bounds get a box far wider than the solution.
const std::vector<KnownProblem>& hock_schittkowski();
const KnownProblem& hock_schittkowski(const std::string& name);

}  // namespace twum::test
