// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "results/answers.hpp"

#include <vector>

/// State of each limit at a design; internal.
namespace twum::inline v0_1::studies {

/// Every limit of a design, and every end of a range that it meets: first the binding ones, the most valuable first,
/// then the others, those with the least slack first. SI: {"text" of a limit or "variable" of an end of a range,
/// "unit", "side": "at least" or "at most",
///  "state": "binds", "holds", "broken", "unknown" or "unreachable", "limit", "value", "slack": how far it is from the limit,
///  "violation", "tolerance": up to which it counts as kept, "allowance": how far beyond the limit still keeps it,
///  "step": 1 % of the limit, "moved": the limit looser by the step,
///  "multiplier": null if the design is no optimum, "worth": of the step [goal],
///  "changes": of each goal by the step, first order; null where it does not trade}
Json standings_json(const DesignReport& report, const std::vector<Goal>& goals);

}  // namespace twum::inline v0_1::studies
