// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "results/search_words.hpp"

#include <twum/studies/results/robust_result.hpp>

#include <string>

namespace twum::studies {

/// {target, yield, nominal, price, limits, tolerances, rounds, correction, largest_yield, densities ...}
Json robust_json(const RobustReport& report);
/// Yield, price, where the risk goes and what tolerances cost, for the terminal.
std::string robust_words(const RobustReport& report, const Goal& goal);

}  // namespace twum::studies
