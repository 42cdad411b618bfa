// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/importance.hpp"

#include <twum/optim/robust.hpp>

#include <functional>

namespace twum::inline v0_1::optim {

/// Whether the yields are known well enough, so that no more products are made.
using EnoughProducts = std::function<bool(const std::vector<YieldEstimate>&)>;

/// Makes products of a design, independent of those of the search, and counts, U5.1.
/// @param run     selects the random numbers; each stream is used for one decision only
/// @param enough  asked after a 32nd of the products and after every doubling, unless statistics of responses are wanted
Verification verify_products(const RobustProblem& problem, const RobustTerms& terms,
                             std::span<const double> x, const SamplePlan& plan, std::uint64_t run,
                             const EnoughProducts& enough);

/// Failure rate below which plain products cannot estimate it.
inline constexpr double kRareRisk = 1e-4;
/// Number of independent scrambled importance samples used below it.
inline constexpr std::uint64_t kScrambles = 16;

/// Whether a yield above 99.99 % is wanted.
bool wants_rare(const RobustProblem& problem);

/// The same verification with yields and shares from importance samples, with Student's interval over the scrambles,
/// U5.5.
/// @param sample  draws the sample of a scramble, from 0
Verification weighted(Verification seen, const RobustTerms& terms,
                      const std::function<ImportanceSample(std::uint64_t)>& sample);

}  // namespace twum::inline v0_1::optim
