// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/importance.hpp"

#include <twum/optim/robust.hpp>

namespace twum::optim {

/// Makes fresh products of a design, which no search has seen, and counts, U5.1.
/// @param attempt  names the stream; a stream decides once
Verification verify_products(const RobustProblem& problem, const RobustTerms& terms,
                             std::span<const double> x, const SamplePlan& plan,
                             std::uint64_t attempt);

}  // namespace twum::optim
