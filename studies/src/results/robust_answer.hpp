// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "results/search_words.hpp"

#include <twum/studies/robust_result.hpp>

#include <string>

namespace twum::studies {

/// "99.16 %"; enough digits to tell 99.9 % from 99.95 %.
std::string percent_words(double share, int digits = 4);
/// Whether a goal is a share of the motors.
bool is_share(const Goal& goal);
/// "+1.2 W" or "+0.16 %": a change of a goal.
std::string goal_change_words(double change, const Goal& goal);
/// {text, target, value, low, high, samples, verdict}
Json robust_yield_json(const RobustYield& yield);
/// {target, yield, nominal, price, limits, tolerances, rounds, correction, largest_yield, densities ...}
Json robust_json(const RobustReport& report);

}  // namespace twum::studies
