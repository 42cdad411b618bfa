// SPDX-License-Identifier: Apache-2.0
#include "tables/heading.hpp"

#include "units/unit_spelling.hpp"
#include "units/unit_system.hpp"

#include <twum/io/words.hpp>

#include <algorithm>
#include <cctype>

namespace twum::inline v0_1::io {
namespace {

// NAME, the unit between `open` and `close`, and nothing behind it.
Heading enclosed(std::string_view text, char open, std::string_view close) {
  const std::size_t at = text.rfind(open);
  if (at == std::string_view::npos || !text.ends_with(close)) return {text, {}, false};
  return {trimmed(text.substr(0, at)),
          trimmed(text.substr(at + 1, text.size() - at - 1 - close.size())), true};
}

}  // namespace

bool names_unit(std::string_view text) {
  return text.empty() || text == "1" || text == "-" ||
         (unit_form_complaint(text).empty() && (is_unit(text) || peak_unit(text)));
}

std::vector<Heading> heading_forms(std::string_view text) {
  text = trimmed(text);
  std::vector<Heading> forms{enclosed(text, '[', "]")};
  for (const Heading& form : {enclosed(text, '(', ")"), enclosed(text, '/', "")})
    if (form.has_unit && names_unit(form.unit)) forms.push_back(form);
  return forms;
}

std::string_view first_word(std::string_view text) {
  const auto end = std::find_if(text.begin(), text.end(),
                                [](unsigned char c) { return std::isalnum(c) == 0 && c != '_'; });
  return text.substr(0, static_cast<std::size_t>(end - text.begin()));
}

}  // namespace twum::inline v0_1::io
