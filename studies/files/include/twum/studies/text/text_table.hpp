// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace twum::studies {

/// Cells in aligned columns, two blanks apart; the first row is the heading.
struct TextTable {
  std::vector<std::vector<std::string>> rows;  ///< the heading, then the others
  bool numbers{false};                         ///< align to the right
};

/// The table as lines, each with its end and without blanks before it. Widths are counted in characters
/// of UTF-8.
std::string aligned(const TextTable& table);

}  // namespace twum::studies
