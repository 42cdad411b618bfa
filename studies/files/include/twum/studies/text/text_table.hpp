// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace twum::studies {

/// Columns of a terminal that nobody has widened.
inline constexpr std::size_t kSummaryWidth = 80;

/// Cells in aligned columns, two blanks apart; the first row is the heading.
struct TextTable {
  std::vector<std::vector<std::string>> rows;  ///< the heading, then the others
  bool numbers{false};                         ///< align to the right
  std::size_t keys{1};                         ///< leading columns that name a row
};

/// The table as lines, each with its end and without blanks before it. Widths are counted in characters
/// of UTF-8.
std::string aligned(const TextTable& table);

/// The same in lines of at most `width` characters: a wide column of words is broken between words, and columns without room follow
/// below, in tables of their own that begin with the keys again. A single word may still be wider.
/// @param width  0: as wide as it is
std::string aligned(const TextTable& table, std::size_t width);

}  // namespace twum::studies
