// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/problem.hpp>

#include <string>

namespace twum::bench {

/// What a solver library answers when it is called directly, with its own scaling and tolerances.
struct DirectAnswer {
  std::vector<double> design;
  std::size_t evaluations{0};  ///< distinct designs
};

/// NLopt's SLSQP (xtol_rel 1e-10, limits within 1e-8) and Ipopt (tol 1e-8, limited memory), from the problem's start.
DirectAnswer slsqp_directly(const optim::Problem& problem);
DirectAnswer ipopt_directly(const optim::Problem& problem);

}  // namespace twum::bench
