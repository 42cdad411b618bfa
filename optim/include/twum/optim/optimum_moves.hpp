// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/certificate.hpp>
#include <twum/optim/problem.hpp>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace twum::optim {

/// How an optimum moves with numbers that its problem holds fixed.
struct OptimumMoves {
  /// Derivatives of the variables by the held numbers: a row for each variable, one entry a held number, user units. 0 for a
  /// variable at a bound that holds it, and for one of whole numbers. Empty where there are none.
  std::vector<double> design;
  std::vector<double> objective;  ///< of the objective's optimum, likewise one entry a held number
  std::string reason;             ///< why there are none: a sentence without its full stop
};

/// Derivatives of a certified optimum by what is held (L5.2, L5.3). They exist where the limits and bounds that are met have
/// independent gradients and multipliers that are not 0, and the Lagrangian curves upwards along them; elsewhere the reason
/// says what fails. Second derivatives are central differences of exact gradients.
/// @param problem  of the variables and then the held numbers, with one objective
/// @param at  the optimum and then the values of the held numbers, user units
/// @param held  how many of the last are held
/// @param certificate  of the optimum
/// Cost: two evaluations with gradient for each variable and each held number, and one.
OptimumMoves optimum_moves(const Problem& problem, std::span<const double> at, std::size_t held,
                           const Certificate& certificate);

}  // namespace twum::optim
