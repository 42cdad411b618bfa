// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "results/answers.hpp"

#include <twum/studies/move.hpp>

#include <string>
#include <vector>

/// How an answer changes with parameters that its study holds fixed, for optimize, size and calibrate. Internal.
namespace twum::studies {

/// {held: {value, unit, slopes: {name: slope}}}
/// @param answer  the numbers that move, in the order of the slopes
Json moves_json(const std::vector<NamedValue>& answer, const std::vector<Move>& moves);

/// By how much the numbers of the answer change if a held parameter is 1 % larger: a row for each of those that count most, and
/// one of them in words. Numbers that do not change are named below the table. Empty where no parameter counts.
/// @param chosen  how many of the numbers, from the first, are values of parameters
/// @param word    what these are: "best"
std::string moves_table(const std::vector<NamedValue>& answer, const std::vector<Move>& moves,
                        std::size_t chosen, const std::string& word);

}  // namespace twum::studies
