// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/certificate.hpp>
#include <twum/optim/options.hpp>

#include <span>

namespace twum::inline v0_1::optim {

/// Certifies any design, however it was found. Cost: about one evaluation with gradient, and two for each variable if
/// kinks or curvature have to be tested. The gradients must be exact; functions that are not smooth give the finding
/// `kink`.
/// @param design  user units, one value for each variable
/// @param options  used are the tolerances, budget, stop and observer
/// @throws InputError for a problem that cannot be posed or a design of the wrong size.
Certificate certify(const Problem& problem, std::span<const double> design,
                    const SolveOptions& options = {});

}  // namespace twum::inline v0_1::optim
