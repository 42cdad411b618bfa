// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace twum::inline v0_1::cli {

/// A table that a command prints: one heading for each column, one row for each item.
struct Listing {
  std::string title;  ///< of the reference page
  std::string text;   ///< introduction of the reference page
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
};

/// The listing as "table", "csv", "json" or "markdown" (the page in docs/reference).
std::string to_text(const Listing& listing, const std::string& format, std::size_t width = 0);

}  // namespace twum::inline v0_1::cli
