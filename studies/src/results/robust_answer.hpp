// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "results/search_words.hpp"

#include <twum/studies/robust_result.hpp>

namespace twum::inline v0_1::studies {

/// Whether a goal is a share of the motors.
bool is_share(const Goal& goal);
/// {text, target, value, low, high, samples, verdict}
Json robust_yield_json(const RobustYield& yield);
/// {target, yield, nominal, price, limits, tolerances, rounds, correction, largest_yield, densities ...}
Json robust_json(const RobustReport& report);

}  // namespace twum::inline v0_1::studies
