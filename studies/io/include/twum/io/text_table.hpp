// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/namespaces.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace twum::inline v0_1::io {

/// Default width of a terminal [characters].
inline constexpr std::size_t kSummaryWidth = 80;

/// Cells in aligned columns, separated by two blanks; the first row is the heading.
struct TextTable {
  std::vector<std::vector<std::string>> rows;  ///< the heading, then the others
  bool numbers{false};                         ///< align to the right
  std::size_t keys{1};                         ///< number of leading columns that identify a row
};

/// The table as lines with line ends and without trailing blanks. Widths are counted in characters of UTF-8.
std::string aligned(const TextTable& table);

/// The same in lines of at most `width` characters: a wide column of words is wrapped between words, and columns
/// without room follow below in tables of their own, which repeat the key columns. A single word may still be wider.
/// @param width  0: no limit
std::string aligned(const TextTable& table, std::size_t width);

}  // namespace twum::inline v0_1::io
