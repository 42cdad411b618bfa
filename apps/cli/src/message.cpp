// SPDX-License-Identifier: Apache-2.0
#include "message.hpp"

#include <twum/io/words.hpp>

#include <algorithm>
#include <cstdio>
#include <string>

namespace twum::inline v0_1::cli {
namespace {

// The lines with a caret in red, for a terminal that may show colours.
std::string with_colour(const std::string& text) {
  std::string out;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = text.substr(begin, end - begin);
    const bool caret = line.find_first_not_of(" |^") == std::string::npos && line.ends_with('^');
    out += (caret ? "\033[1;31m" + line + "\033[0m" : line) + (end < text.size() ? "\n" : "");
    begin = end + 1;
  }
  return out;
}

}  // namespace

void say(std::string_view text) {
  std::fprintf(stderr, "%s\n", studies::printable_lines(text).c_str());
}

void say_with_red_carets(std::string_view text) {
  std::fprintf(stderr, "%s\n", with_colour(studies::printable_lines(text)).c_str());
}

}  // namespace twum::inline v0_1::cli
