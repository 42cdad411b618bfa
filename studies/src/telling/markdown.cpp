// SPDX-License-Identifier: Apache-2.0
#include "telling/goal_parts.hpp"
#include "telling/renderers.hpp"

namespace twum::inline v0_1::studies::telling {
namespace {

// Letters that Markdown would take as markup.
std::string escaped(const std::string& text) {
  std::string safe;
  for (const char letter : text) {
    if (std::string_view("\\`*_[]<>|#").find(letter) != std::string_view::npos) safe += '\\';
    safe += letter;
  }
  return safe;
}

std::string row_of(const std::vector<Phrase>& row) {
  std::string text = "|";
  for (const Phrase& cell : row) text += " " + markdown(cell) + " |";
  return text + "\n";
}

}  // namespace

std::string markdown(const Table& table) {
  std::string text = row_of(table.heads) + "|";
  for (std::size_t i = 0; i < table.heads.size(); ++i)
    text += i < table.keys ? " --- |" : " ---: |";
  text += "\n";
  for (const std::vector<Phrase>& row : table.rows) text += row_of(row);
  return text;
}

std::string markdown(const Phrase& phrase) {
  std::string text;
  bool strong = false;  // neighbouring parts that stand out share one pair of marks
  for (const Part& part : phrase) {
    if (part.strong != strong) text += "**";
    strong = part.strong;
    text += escaped(written(part, Writing::read));
  }
  return strong ? text + "**" : text;
}

std::string markdown(const Headline& headline) {
  std::string text = "**" + escaped(headline.badge) + "**\n";
  for (const Phrase& phrase : headline.sentences)
    text += "\n" + markdown(capitalized(phrase)) + "\n";
  if (!headline.remarks.empty()) text += "\n";
  for (const Phrase& phrase : headline.remarks) text += "- " + markdown(phrase) + "\n";
  return text;
}

std::string markdown(const std::vector<Section>& sections) {
  std::string text;
  for (const Section& section : sections) {
    if (is_picture(section)) continue;
    text += "\n## " + markdown(capitalized(section.heading)) + "\n";
    if (!section.note.empty()) text += "\n" + markdown(capitalized(section.note)) + "\n";
    for (const Phrase& phrase : section.sentences)
      text += "\n" + markdown(capitalized(phrase)) + "\n";
    if (!section.remarks.empty()) text += "\n";
    for (const Phrase& phrase : section.remarks) text += "- " + markdown(phrase) + "\n";
    for (const Table& table : section.tables) text += "\n" + markdown(table);
  }
  return text;
}

}  // namespace twum::inline v0_1::studies::telling
