// SPDX-License-Identifier: Apache-2.0
#include "telling/goal_parts.hpp"
#include "telling/html_parts.hpp"
#include "telling/renderers.hpp"

#include <algorithm>
#include <cctype>

namespace twum::inline v0_1::studies::telling {
namespace {

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

bool has_number(const Phrase& cell) {
  return std::ranges::any_of(cell, [](const Part& part) {
    const bool counts = part.kind == Part::Kind::words && !part.text.empty() &&
                        std::isdigit(static_cast<unsigned char>(part.text.front())) != 0;
    return counts || part.kind == Part::Kind::value || part.kind == Part::Kind::share;
  });
}

// Words are aligned to the left, numbers to the right.
bool is_of_words(const Table& table, std::size_t column) {
  return column < table.keys || std::ranges::none_of(table.rows, [column](const auto& row) {
           return column < row.size() && has_number(row[column]);
         });
}

std::string row_of(const std::string& cell, const std::vector<Phrase>& row, const Table& table) {
  std::string text;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const std::string side = is_of_words(table, i) ? "left" : "right";
    text += "<" + cell + " style=\"text-align: " + side + "\">" + html(row[i]) + "</" + cell + ">";
  }
  return element("tr", text);
}

// Points of a picture in a text; more are for pages.
constexpr std::size_t kMostPoints = 5000;

bool is_drawn(const Chart& chart) {
  return chart.colours.name.empty() && std::ranges::all_of(chart.series, [](const Series& series) {
           return series.y.values.size() <= kMostPoints;
         });
}

constexpr double kAlone = 460;  // width of a chart [pixels]

// Panels of a matrix are too many and too small.
bool has_charts(const Section& section) {
  return section.on_page && !section.charts.empty() && section.columns == 0 &&
         std::ranges::all_of(section.charts, is_drawn);
}

}  // namespace

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

std::string html(const Phrase& phrase) {
  std::string text;
  for (const Part& part : phrase) {
    const std::string words = harmless(written(part, Writing::page));
    text += part.strong ? "<b>" + words + "</b>" : words;
  }
  return text;
}

std::string html(const Table& table) {
  std::string text = table.heads.empty() ? "" : row_of("th", table.heads, table);
  for (const std::vector<Phrase>& row : table.rows) text += row_of("td", row, table);
  // A wide table scrolls by itself and does not widen what is around it, whose sentences would be cut off.
  return "<div style=\"overflow-x: auto; width: 0; min-width: 100%\">\n" +
         element("table", "\n" + text) + "</div>\n";
}

std::string html(const Headline& headline) {
  return element("p", "<b>" + harmless(headline.badge) + "</b>") + paragraphs(headline.sentences) +
         bullets(headline.remarks);
}

std::string html(const std::vector<Section>& sections, const std::string& heading, double several) {
  std::string text;
  for (const Section& section : sections) {
    if (is_picture(section) && !has_charts(section)) continue;
    text += section.wide ? "<section class=\"wide\">\n" : "<section>\n";
    text += element(heading, html(capitalized(section.heading)));
    if (!section.note.empty()) text += element("p", html(capitalized(section.note)));
    for (std::size_t i = 0; has_charts(section) && i < section.charts.size(); ++i)
      text += html(section.charts[i], section.charts.size() > 1 ? several : kAlone);
    text += paragraphs(section.sentences) + bullets(section.remarks);
    for (const Table& table : section.tables) text += html(table);
    text += "</section>\n";
  }
  return text;
}

std::string summary_html(const StudyResult& result, const Sources& sources) {
  const KnownMetrics known(result.own_metrics);
  const Headline told = headline(result);
  std::string text =
      element("h3", harmless(told.title)) + html(told) + html(sections(result, sources));
  for (const std::string& note : result.model_notes)
    text += element("p", "note: " + harmless(note));
  return text;
}

}  // namespace twum::inline v0_1::studies::telling
