// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace twum::inline v0_1::studies {

/// One row of a comparison of results.
struct ComparisonRow {
  std::string group;  ///< "study", "design", "metric", or a group of the study kind
  std::string name;   ///< name of the quantity
  std::string unit;   ///< SI; empty for words and counts
  /// if it is not a number: one word for each result, empty where a result has none
  std::vector<std::string> words;
  /// if it is a number: one value for each result, SI; NaN where a result has none
  std::vector<double> values;
};

/// Results of several studies side by side.
struct Comparison {
  std::vector<std::string> names;   ///< of the directories
  std::vector<ComparisonRow> rows;  ///< in the order of the summaries, gaps included
};

/// Reads the summary.json of each directory. A quantity that only some of them have is a row with gaps. Studies of
/// different kinds have outcome, counts, versions and quantities of the same name in common.
/// @throws InputError if there is no such directory or no summary in it; StoreError if it is damaged
Comparison compare_results(std::span<const std::string> directories);

/// The comparison as a table for a terminal, in engineering units, with differences to the first result.
/// @param width  of the lines [characters]; 0: no limit
std::string comparison_text(const Comparison& comparison, std::size_t width);

/// The same as Markdown.
std::string comparison_markdown(const Comparison& comparison);

}  // namespace twum::inline v0_1::studies
