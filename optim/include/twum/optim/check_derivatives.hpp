// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/problem.hpp>

#include <span>
#include <string>
#include <vector>

namespace twum::inline v0_1::optim {

/// One entry of a Jacobian beside a difference quotient of the evaluator's values, in user units.
struct DerivativeCheck {
  std::string response{};  ///< name of the objective or constraint
  std::string variable{};  ///< name of the variable
  double given{0};         ///< entry of the evaluator's Jacobian
  double difference{0};    ///< extrapolated central difference
  double uncertainty{0};   ///< of the difference, from two step sizes; large at a kink
  bool agrees{true};       ///< the two differ by less than the uncertainty explains
};

/// Compares the evaluator's Jacobian at a design with differences of its values, entry by entry. Use it once for a new
/// evaluator: with a wrong entry a search ends anywhere, and its answer gets no certificate (O5.1).
///
/// The steps are 1e-3 and 5e-4 of a variable's size, which is the larger of its magnitude and a thousandth of its range. The
/// design is first moved inwards by one step from a bound. Entries of variables with a narrower range, and entries that the
/// evaluator marks as not smooth, are left out. Costs 4 evaluations for each variable and one with derivatives. Entries
/// smaller than about 1e-8 of the response over the variable's size cannot be checked; their uncertainty says so.
/// @return one for each entry, all variables of the first response first
/// @throws InputError if validate() refuses the problem, for a design of the wrong size, and for one that cannot be evaluated
std::vector<DerivativeCheck> check_derivatives(const Problem& problem,
                                               std::span<const double> design);

}  // namespace twum::inline v0_1::optim
