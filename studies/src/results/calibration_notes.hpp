// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/calibrate_result.hpp>

#include <string>
#include <vector>

namespace twum::inline v0_1::studies {

/// Chance below which a misfit is more than scatter.
inline constexpr double kUnlikely = 0.05;

/// Chance below which it makes a fit poor, however small it is.
inline constexpr double kRare = 0.01;

/// "min" or "max": the end of its range that holds a parameter.
const char* end_word(CalibrateResult::Bound bound);

/// The data leave more room for a parameter than the range that was searched.
bool wider_than_range(const CalibrateResult::Estimate& estimate);

/// "hardly determined", "held by its max" ...; empty where the interval says all.
std::string estimate_remark(const CalibrateResult& result,
                            const CalibrateResult::Estimate& estimate);

/// What to know before believing the estimates, a sentence each, the gravest first; the same on a
/// terminal, in summary.json and on the page.
std::vector<std::string> calibration_notes(const CalibrateResult& result);

}  // namespace twum::inline v0_1::studies
