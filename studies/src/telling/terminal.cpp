// SPDX-License-Identifier: Apache-2.0
#include "telling/renderers.hpp"

#include <twum/io/text_table.hpp>
#include <twum/io/words.hpp>

#include <algorithm>

namespace twum::inline v0_1::studies::telling {
namespace {

std::vector<std::string> cells(const std::vector<Phrase>& row, std::size_t most) {
  std::vector<std::string> list;
  for (std::size_t i = 0; i < row.size() && (most == 0 || i < most); ++i)
    list.push_back(written(row[i], Writing::typed));
  return list;
}

// More rows than these are in summary.json and on the page.
constexpr std::size_t kMostRows = 20;

std::string table_text(const Table& table, std::size_t rows, std::size_t width) {
  TextTable text{{cells(table.heads, table.typed)}, false, table.keys};
  for (std::size_t i = 0; i < rows; ++i) text.rows.push_back(cells(table.rows[i], table.typed));
  return aligned(text, width);
}

std::string summary_table(const Table& table) {
  const std::size_t shown = std::min(table.rows.size(), kMostRows);
  const std::size_t left = table.rows.size() - shown;
  return table_text(table, shown, kSummaryWidth) +
         (left == 0 ? "" : "and " + counted(left, "more row") + ", see the report\n");
}

std::string lines(const std::vector<Phrase>& sentences) {
  std::string text;
  for (const Phrase& phrase : sentences) text += written(phrase, Writing::typed) + "\n";
  return text;
}

}  // namespace

bool is_picture(const Section& section) {
  return section.sentences.empty() && section.remarks.empty() && section.tables.empty();
}

std::string terminal_text(const Table& table, std::size_t width) {
  return table_text(table, table.rows.size(), width);
}

std::string terminal_text(const Headline& headline) {
  return lines(headline.sentences) + lines(headline.remarks);
}

std::string terminal_text(const std::vector<Section>& sections) {
  std::string text;
  for (const Section& section : sections) {
    if (is_picture(section)) continue;
    if (!text.empty()) text += "\n";
    text += written(section.heading, Writing::typed) + "\n";
    text += lines(section.sentences) + lines(section.remarks);
    for (const Table& table : section.tables)
      text += (&table == &section.tables.front() ? "" : "\n") + summary_table(table);
  }
  return text;
}

}  // namespace twum::inline v0_1::studies::telling
