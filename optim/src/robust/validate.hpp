// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/robust_problem.hpp>

namespace twum::inline v0_1::optim {

/// @throws InputError unless the problem is valid
void validate_robust(const RobustProblem& problem);

}  // namespace twum::inline v0_1::optim
