// SPDX-License-Identifier: Apache-2.0
#include "datasheet/parts.hpp"

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
    text += "<div><dt>" + escaped(written(name, telling::Writing::read)) + "</dt><dd>" +
            escaped(written(value, telling::Writing::read)) + "</dd></div>\n";
  return text.empty() ? "" : "<dl>\n" + text + "</dl>\n";
}

telling::Part shown(double value, std::string_view unit, std::string_view name) {
  const bool share = unit == "1" && name.find("efficiency") != std::string_view::npos;
  return share ? telling::share_part(value) : telling::value_part(value, std::string(unit));
}

}  // namespace twum::studies::datasheet
