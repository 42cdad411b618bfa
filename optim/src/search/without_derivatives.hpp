// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "problem/session.hpp"

namespace twum::inline v0_1::optim {

/// Solves a problem whose evaluator gives no Jacobian, with the named derivative-free solver. Its certificate is not
/// measured: no more than feasibility is known of the answer.
/// @throws InputError for a solver that needs derivatives
Result solve_without_derivatives(const Problem& problem, const SolveOptions& options,
                                 const Deadline& deadline);

}  // namespace twum::inline v0_1::optim
