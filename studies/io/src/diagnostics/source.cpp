// SPDX-License-Identifier: Apache-2.0
#include <twum/io/source.hpp>

#include "text/file_content.hpp"
#include "text/utf8.hpp"

#include <algorithm>

namespace twum::inline v0_1::io {

Source::Source(std::string name, std::string text)
    : name_(std::move(name)), text_(std::move(text)), line_begins_{0} {
  for (std::size_t at = text_.find('\n'); at != std::string::npos; at = text_.find('\n', at + 1)) {
    line_begins_.push_back(at + 1);
  }
}

std::string_view Source::line(int number) const {
  const auto index = static_cast<std::size_t>(number - 1);
  if (number < 1 || index >= line_begins_.size()) return {};
  const std::size_t begin = line_begins_[index];
  const bool last = index + 1 == line_begins_.size();
  const std::size_t end = last ? text_.size() : line_begins_[index + 1] - 1;
  std::string_view line = std::string_view(text_).substr(begin, end - begin);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

SourceMark Source::mark(int line_from_0, int byte) const {
  const std::string_view before =
      line(line_from_0 + 1).substr(0, static_cast<std::size_t>(std::max(byte, 0)));
  int column = 1;
  for (const char c : before) column += (static_cast<unsigned char>(c) & 0xC0U) == 0x80U ? 0 : 1;
  return {line_from_0 + 1, column};
}

SourceMark Source::mark_within(SourceMark begin, std::string_view value, std::size_t byte) const {
  if (byte == 0) return begin;
  const std::string_view whole = line(begin.line);
  std::size_t at = byte_of(whole, begin.column - 1);
  if (at < whole.size() && (whole[at] == '"' || whole[at] == '\'')) ++at;
  if (!whole.substr(at).starts_with(value)) return begin;
  return mark(begin.line - 1, static_cast<int>(at + std::min(byte, value.size())));
}

Source read_source(const std::string& path) {
  std::string text = file_content(path, kLargestFile);
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
  return {path == "-" ? "standard input" : path, std::move(text)};
}

}  // namespace twum::inline v0_1::io
