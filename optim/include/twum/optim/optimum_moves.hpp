// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/certificate.hpp>
#include <twum/optim/problem.hpp>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace twum::inline v0_1::optim {

/// Derivatives of an optimum with respect to numbers that its problem holds fixed.
struct OptimumMoves {
  /// Derivatives of the variables: one row for each variable with one entry for each held number, user units. 0 for a
  /// variable at an active bound and for an integer variable. Empty if they do not exist.
  std::vector<double> design;
  /// derivatives of the optimal objective, one entry for each held number
  std::vector<double> objective;
  std::string reason;  ///< why they do not exist: a sentence without the full stop
};

/// Derivatives of a certified optimum with respect to the held numbers (L5.2, L5.3). They exist if the active limits
/// and bounds have independent gradients and nonzero multipliers, and if the Lagrangian has positive curvature along
/// them. Otherwise `reason` says what fails. Second derivatives are central differences of exact gradients.
/// @param problem  a function of the variables followed by the held numbers, with one objective
/// @param at  the optimum followed by the values of the held numbers, user units
/// @param held  number of held numbers
/// @param certificate  of the optimum Cost: two evaluations with gradient for each variable and each held number, and
///         one more.
OptimumMoves optimum_moves(const Problem& problem, std::span<const double> at, std::size_t held,
                           const Certificate& certificate);

}  // namespace twum::inline v0_1::optim
