// SPDX-License-Identifier: Apache-2.0
#include "telling/goal_parts.hpp"
#include "telling/renderers.hpp"

namespace twum::studies::telling {
namespace {

std::string harmless(const std::string& text) {
  std::string safe;
  for (const char letter : text) {
    if (letter == '<')
      safe += "&lt;";
    else if (letter == '>')
      safe += "&gt;";
    else if (letter == '&')
      safe += "&amp;";
    else
      safe += letter;
  }
  return safe;
}

std::string element(const std::string& name, const std::string& content) {
  return "<" + name + ">" + content + "</" + name + ">\n";
}

std::string paragraphs(const std::vector<Phrase>& phrases) {
  std::string text;
  for (const Phrase& phrase : phrases) text += element("p", html(capitalized(phrase)));
  return text;
}

std::string bullets(const std::vector<Phrase>& phrases) {
  std::string text;
  for (const Phrase& phrase : phrases) text += element("li", html(phrase));
  return text.empty() ? text : element("ul", "\n" + text);
}

std::string row_of(const std::string& cell, const std::vector<Phrase>& row) {
  std::string text;
  for (const Phrase& one : row) text += "<" + cell + ">" + html(one) + "</" + cell + ">";
  return element("tr", text);
}

}  // namespace

std::string html(const Phrase& phrase) {
  std::string text;
  for (const Part& part : phrase) {
    const std::string words = harmless(written(part, Writing::page));
    text += part.strong ? "<b>" + words + "</b>" : words;
  }
  return text;
}

std::string html(const Table& table) {
  std::string text = row_of("th", table.heads);
  for (const std::vector<Phrase>& row : table.rows) text += row_of("td", row);
  return element("table", "\n" + text);
}

std::string html(const Headline& headline) {
  return element("p", "<b>" + harmless(headline.badge) + "</b>") + paragraphs(headline.sentences) +
         bullets(headline.remarks);
}

std::string html(const std::vector<Section>& sections) {
  std::string text;
  for (const Section& section : sections) {
    if (is_picture(section)) continue;
    text += element("h4", html(capitalized(section.heading)));
    if (!section.note.empty()) text += element("p", html(capitalized(section.note)));
    text += paragraphs(section.sentences) + bullets(section.remarks);
    for (const Table& table : section.tables) text += html(table);
  }
  return text;
}

std::string summary_html(const StudyResult& result, const Sources& sources) {
  const Headline told = headline(result);
  std::string text =
      element("h3", harmless(told.title)) + html(told) + html(sections(result, sources));
  for (const std::string& note : result.model_notes)
    text += element("p", "note: " + harmless(note));
  return text;
}

}  // namespace twum::studies::telling
