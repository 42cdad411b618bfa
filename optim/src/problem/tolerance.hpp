// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/problem.hpp>

namespace twum::inline v0_1::optim {

/// Magnitude of the terms of a response at a design, max_j |x_j dc/dx_j|, user units; 0 without a Jacobian. A variable
/// near zero counts with a ten-thousandth of its unit or of its range, whichever is smaller.
double term_magnitude(const Problem& problem, std::size_t response, const Evaluation& evaluation,
                      std::span<const double> design);

/// Amount by which a limit may be broken and is still kept, user units (O2.1): the constraint's own tolerance, or
/// `relative` times the larger of |bound| and the magnitude of the terms.
double limit_tolerance(const Constraint& constraint, double bound, double terms, double relative);

/// Largest violation of a limit over its tolerance, times `relative`: at most `relative` if every limit is kept.
double relative_violation(const Problem& problem, const Evaluation& evaluation,
                          std::span<const double> design, double relative);

}  // namespace twum::inline v0_1::optim
