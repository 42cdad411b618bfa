// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "results/answers.hpp"

#include <twum/studies/move.hpp>

#include <vector>

namespace twum::inline v0_1::studies {

/// How an answer changes with parameters that its study holds fixed: {held: {value, unit, slopes: {name: slope}}}; internal.
/// @param answer  the numbers that move, in the order of the slopes
Json moves_json(const std::vector<NamedValue>& answer, const std::vector<Move>& moves);

}  // namespace twum::inline v0_1::studies
