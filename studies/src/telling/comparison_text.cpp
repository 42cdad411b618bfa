// SPDX-License-Identifier: Apache-2.0
#include "telling/renderers.hpp"

#include <twum/io/words.hpp>
#include <twum/studies/comparison.hpp>

#include <cmath>

namespace twum::inline v0_1::studies {
namespace {

using namespace telling;

// Differences in per cent of the first value, or in its unit if that is zero.
Part difference_part(const ComparisonRow& row, std::size_t i) {
  const double first = row.values.front(), value = row.values[i];
  if (std::isnan(first) || std::isnan(value)) return "";
  if (value == first) return "same";
  return change(first == 0 ? value_part(value, row.unit)
                           : share_part((value - first) / std::fabs(first), 3));
}

Part word_part(const std::string& word) { return word.empty() ? "-" : printable(word); }

std::vector<Phrase> row_of(const ComparisonRow& row, bool group) {
  std::vector<Phrase> cells{{group ? row.group : ""}, {row.name}};
  for (std::size_t i = 0; i < row.words.size(); ++i) {
    cells.push_back({word_part(row.words[i])});
    if (i > 0) cells.push_back({""});
  }
  for (std::size_t i = 0; i < row.values.size(); ++i) {
    constexpr int kDigits = 6;
    cells.push_back({value_part(row.values[i], row.unit, kDigits)});
    if (i > 0) cells.push_back({difference_part(row, i)});
  }
  return cells;
}

// A row for each quantity; its group stands before the first of them.
Table comparison_table(const Comparison& comparison) {
  Table table{"comparison", {{""}, {""}}, {}};
  table.keys = 2;
  for (std::size_t i = 0; i < comparison.names.size(); ++i) {
    table.heads.push_back({printable(comparison.names[i])});
    if (i > 0) table.heads.push_back({"difference"});
  }
  std::string group;
  for (const ComparisonRow& row : comparison.rows) {
    table.rows.push_back(row_of(row, row.group != group));
    group = row.group;
  }
  return table;
}

}  // namespace

std::string comparison_text(const Comparison& comparison, std::size_t width) {
  return terminal_text(comparison_table(comparison), width);
}

std::string comparison_markdown(const Comparison& comparison) {
  return markdown(comparison_table(comparison));
}

}  // namespace twum::inline v0_1::studies
