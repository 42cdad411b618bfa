// SPDX-License-Identifier: Apache-2.0
#include "solid/written_share.hpp"

#include <twum/base/error.hpp>
#include <twum/io/diagnostics.hpp>
#include <twum/io/number.hpp>
#include <twum/io/yaml_loader.hpp>

#include <algorithm>

namespace twum::inline v0_1::cli {
namespace {

constexpr const char* kEntry = "stiffness_share";

const studies::YamlNode& teeth_of(const studies::YamlNode& root) {
  const studies::YamlNode* node = &root;
  for (const char* key : {"motor", "stator", "geometry", "teeth"}) {
    node = node->find(key);
    TWUM_ASSERT(node != nullptr);  // the reader has found teeth
  }
  return *node;
}

// The byte of a place. Columns count characters, of which all bytes but the first begin with the bits 10.
std::size_t byte_of(const std::string& text, studies::SourceMark mark) {
  std::size_t at = 0;
  for (int line = 1; line < mark.line; ++line) at = text.find('\n', at) + 1;
  const auto inside = [&] { return (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U; };
  for (int column = 1; column < mark.column; ++column) {
    ++at;
    while (at < text.size() && inside()) ++at;
  }
  return at;
}

}  // namespace

std::string with_stiffness_share(const studies::Source& source, double share) {
  studies::Diagnostics diagnostics(source);
  const studies::YamlNode root = studies::load_yaml(diagnostics);
  const studies::YamlNode& teeth = teeth_of(root);
  const std::string value = studies::rounded_text(share, 6);
  std::string text = source.text();
  if (const studies::YamlNode* found = teeth.find(kEntry)) {
    const std::size_t at = byte_of(text, found->mark);
    const std::size_t begin = text.find(found->scalar, at);  // behind a quote
    return text.replace(begin, found->scalar.size(), value);
  }
  // Before the first entry, in braces or on a line of its own with the same indentation.
  const studies::SourceMark first = teeth.entries.front().key_mark;
  const bool braces = text[byte_of(text, teeth.mark)] == '{';
  const std::string end =
      braces ? ", " : "\n" + std::string(static_cast<std::size_t>(first.column - 1), ' ');
  return text.insert(byte_of(text, first), std::string(kEntry) + ": " + value + end);
}

}  // namespace twum::inline v0_1::cli
