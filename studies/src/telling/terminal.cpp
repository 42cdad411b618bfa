// SPDX-License-Identifier: Apache-2.0
#include "telling/renderers.hpp"

#include <twum/io/text_table.hpp>

namespace twum::studies::telling {
namespace {

std::vector<std::string> cells(const std::vector<Phrase>& row) {
  std::vector<std::string> list;
  for (const Phrase& phrase : row) list.push_back(written(phrase, Writing::typed));
  return list;
}

std::string table_text(const Table& table) {
  TextTable text{{cells(table.heads)}};
  for (const std::vector<Phrase>& row : table.rows) text.rows.push_back(cells(row));
  return aligned(text, kSummaryWidth);
}

std::string lines(const std::vector<Phrase>& sentences) {
  std::string text;
  for (const Phrase& phrase : sentences) text += written(phrase, Writing::typed) + "\n";
  return text;
}

}  // namespace

std::string terminal_text(const Headline& headline) {
  return lines(headline.sentences) + lines(headline.remarks);
}

std::string terminal_text(const std::vector<Section>& sections) {
  std::string text;
  for (const Section& section : sections) {
    if (section.sentences.empty() && section.tables.empty()) continue;
    if (!text.empty()) text += "\n";
    text += written(section.heading, Writing::typed) + "\n";
    text += lines(section.sentences);
    for (const Table& table : section.tables)
      text += (&table == &section.tables.front() ? "" : "\n") + table_text(table);
  }
  return text;
}

}  // namespace twum::studies::telling
