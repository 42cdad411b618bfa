// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/calibrate_result.hpp>

#include <string>

namespace twum::inline v0_1::studies {

/// A parameter that rises or falls, in words: "a stiffer layer", "less friction"; "more NAME" where there are none.
std::string rising_words(const std::string& parameter, bool rises);

/// "a softer layer (youngs_modulus -10 %) with a smaller wave (amplitude -3.2 %)"
std::string combination_words(const CalibrateResult::Combination& combination);

/// Why a result at a fold has no changes with fixed parameters, and no correlations.
std::string fold_words();

/// " at 100 rpm" of a torque; " of no_load_speed" of what has no argument.
std::string place_words(const CalibrateResult::Point& point);

/// "no_load_speed (points.csv)"; "torque" for torques at speeds
std::string column_name(const CalibrateResult::ColumnOffset& offset);

/// "the 13 readings fit best if each is 5 rpm too large"
std::string offset_words(const CalibrateResult::ColumnOffset& offset);

}  // namespace twum::inline v0_1::studies
