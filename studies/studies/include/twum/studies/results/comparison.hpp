// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

namespace twum::studies {

/// One thing that results of studies are compared by.
struct ComparisonRow {
  std::string group;               ///< "study", "design", "metric", or what a kind calls it
  std::string name;                ///< of what is compared
  std::string unit;                ///< SI; empty for words and counts
  std::vector<std::string> words;  ///< one for each result if it is no number; empty: none there
  std::vector<double> values;      ///< otherwise, SI; NaN: none there
};

/// Results of several studies side by side.
struct Comparison {
  std::vector<std::string> names;   ///< of the directories
  std::vector<ComparisonRow> rows;  ///< in the order of the summaries, gaps included
};

/// Reads the summary.json of each directory. What only some of them have is a row with gaps: studies
/// of different kinds share outcome, counts and versions, and whatever else has the same name.
/// @throws InputError if there is no such directory or no summary in it; StoreError if it is damaged
Comparison compare_results(std::span<const std::string> directories);

}  // namespace twum::studies
