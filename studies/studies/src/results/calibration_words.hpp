// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/results/calibrate_result.hpp>

#include <string>

namespace twum::studies {

/// A parameter that rises or falls, in words: "a stiffer layer", "less friction"; "more NAME" where there are none.
std::string rising_words(const std::string& parameter, bool rises);

/// "a softer layer (youngs_modulus -10 %) with a smaller wave (amplitude -3.2 %)"
std::string combination_words(const CalibrateResult::Combination& combination);

}  // namespace twum::studies
