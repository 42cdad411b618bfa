// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/importance.hpp"

#include <twum/optim/robust.hpp>

#include <functional>

namespace twum::optim {

/// Makes fresh products of a design, which no search has seen, and counts, U5.1.
/// @param attempt  names the stream; a stream decides once
Verification verify_products(const RobustProblem& problem, const RobustTerms& terms,
                             std::span<const double> x, const SamplePlan& plan, std::uint64_t run);

/// A share of failing products below which plain ones cannot tell it.
inline constexpr double kRareRisk = 1e-4;
/// Independent scrambles of the weighted products that tell it then.
inline constexpr std::uint64_t kScrambles = 16;

/// Whether a yield above 99.99 % is wanted.
bool wants_rare(const RobustProblem& problem);

/// The same verification with yields and shares from weighted samples, with Student's interval over the scrambles, U5.5.
/// @param sample  draws the sample of a scramble, from 0
Verification weighted(Verification seen, const RobustTerms& terms,
                      const std::function<ImportanceSample(std::uint64_t)>& sample);

}  // namespace twum::optim
