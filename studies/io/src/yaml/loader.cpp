// SPDX-License-Identifier: Apache-2.0
#include <twum/io/yaml_loader.hpp>

#include "text/utf8.hpp"
#include "yaml/tree_builder.hpp"

#include <string_view>

namespace twum::inline v0_1::io {
namespace {

bool is_control(std::string_view text) {
  const auto c = static_cast<unsigned char>(text[0]);
  if (c == '\r') return text.size() < 2 || text[1] != '\n';
  return (c < 0x20 && c != '\n' && c != '\t') || c == 0x7F;
}

// Adds an error at the first byte that is not text; true if there is one.
bool refuse_binary(Diagnostics& diagnostics) {
  const std::string_view text = diagnostics.source().text();
  int line = 0;
  std::size_t line_begin = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = utf8_length(text.substr(at));
    if (length == 0 || is_control(text.substr(at))) {
      const SourceMark mark = diagnostics.source().mark(line, static_cast<int>(at - line_begin));
      diagnostics.add(mark, {}, length == 0 ? "a byte that is not UTF-8" : "a control character",
                      "a file is UTF-8 text");
      return true;
    }
    if (text[at] == '\n') {
      ++line;
      line_begin = at + 1;
    }
    at += length;
  }
  return false;
}

}  // namespace

YamlNode load_yaml(Diagnostics& diagnostics) {
  if (!refuse_binary(diagnostics)) return build_tree(diagnostics);
  YamlNode nothing;
  nothing.kind = YamlNode::Kind::refused;
  return nothing;
}

}  // namespace twum::inline v0_1::io
