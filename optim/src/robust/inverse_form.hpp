// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/margin.hpp"

namespace twum::inline v0_1::optim {

/// G(x, beta) of U3.2: the least margin of built products at the distance beta from the design.
struct InversePoint {
  MarginPoint at;                 ///< the inverse most probable point u and g there
  double by_beta{0.0};            ///< dG/dbeta = -|d|, U3.3; dG/dx is `at.by_design`
  std::vector<double> direction;  ///< alpha = -d / |d|, u = beta alpha
  bool converged{false};          ///< the last step of u was less than 1e-8
};

/// Solves U3.2; a negative beta asks for the largest margin at the distance |beta|. Depends on its arguments only.
/// Costs one gradient of the margin for each of about five steps.
/// @param start  a unit vector near alpha; empty: the gradient at the design gives one
InversePoint inverse_form(const RobustProblem& problem, const Margin& margin,
                          std::span<const double> x, double beta, std::span<const double> start);

}  // namespace twum::inline v0_1::optim
