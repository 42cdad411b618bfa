// SPDX-License-Identifier: Apache-2.0
#include "datasheet/parts.hpp"

#include <twum/io/engineering.hpp>
#include <twum/io/number.hpp>

#include <array>
#include <cstdio>

namespace twum::studies::datasheet {

std::string escaped(std::string_view text) {
  std::string safe;
  for (const char letter : text) {
    switch (letter) {
      case '&': safe += "&amp;"; break;
      case '<': safe += "&lt;"; break;
      case '>': safe += "&gt;"; break;
      case '"': safe += "&quot;"; break;
      default: safe += letter;
    }
  }
  return safe;
}

std::string place(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f", value);
  return text.data();
}

std::string element(std::string_view name,
                    std::initializer_list<std::pair<std::string_view, std::string>> attributes,
                    std::string_view content) {
  std::string text = "<" + std::string(name);
  for (const auto& [key, value] : attributes)
    text += " " + std::string(key) + "=\"" + escaped(value) + "\"";
  return text + ">" + std::string(content) + "</" + std::string(name) + ">";
}

std::string list(const std::vector<Line>& lines) {
  std::string text;
  for (const auto& [name, value] : lines)
    text += "<div><dt>" + escaped(name) + "</dt><dd>" + escaped(value) + "</dd></div>\n";
  return text.empty() ? "" : "<dl>\n" + text + "</dl>\n";
}

std::string shown(double value, std::string_view unit, std::string_view name) {
  if (unit == "1" && name.find("efficiency") != std::string_view::npos)
    return rounded_text(100 * value, 4) + " %";
  return printed_engineering(value, unit);
}

}  // namespace twum::studies::datasheet
