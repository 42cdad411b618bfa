// SPDX-License-Identifier: Apache-2.0
#include "report/page_parts.hpp"

#include "report/encode.hpp"

#include <twum/base/error.hpp>

namespace twum::inline v0_1::studies {

std::string embedded(const Json& json) {
  std::string text;
  for (const char letter : json.dump(-1, ' ', false, Json::error_handler_t::replace)) {
    if (letter == '<')
      text += "\\u003c";
    else
      text += letter;
  }
  return text;
}

std::string dressed(std::string_view page, const HashedText& style, const HashedText& script) {
  const auto source = [](std::string_view hash) { return "'sha256-" + base64(hash) + "'"; };
  std::string text = filled(page, "@SCRIPT_HASH@", source(script.hash));
  text = filled(text, "@STYLE_HASH@", source(style.hash));
  text = filled(text, "/*STYLE*/", style.text);
  return filled(text, "/*SCRIPT*/", script.text);
}

std::string filled(std::string_view page, std::string_view mark, std::string_view content) {
  const std::size_t at = page.find(mark);
  TWUM_ASSERT(at != std::string_view::npos);
  return std::string(page.substr(0, at)) + std::string(content) +
         std::string(page.substr(at + mark.size()));
}

}  // namespace twum::inline v0_1::studies
