// SPDX-License-Identifier: Apache-2.0
#include "yaml/yaml_text.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace twum::inline v0_1::io {
namespace {

constexpr std::size_t kLineLength = 90;

// Words and quantities, which mean the same with and without quotation marks.
bool is_plain(const std::string& text) {
  static constexpr std::array<std::string_view, 2> kNothing{"~", "null"};
  const auto inside = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string_view(" _./()<>=+*^-").find(c) != std::string_view::npos;
  };
  return !text.empty() && std::isalnum(static_cast<unsigned char>(text.front())) != 0 &&
         text.back() != ' ' && std::all_of(text.begin(), text.end(), inside) &&
         std::find(kNothing.begin(), kNothing.end(), text) == kNothing.end();
}

std::string scalar_text(const std::string& text) {
  return is_plain(text) ? text : double_quoted(text);
}

// contains mappings of mappings, which are hard to read in one line
bool is_deep(const YamlNode& node) {
  return std::any_of(node.entries.begin(), node.entries.end(), [](const YamlEntry& entry) {
    return entry.value.kind == YamlNode::Kind::mapping || entry.value.kind == YamlNode::Kind::list;
  });
}

std::string item_lines(const YamlNode& list, std::size_t depth) {
  std::string out;
  for (const YamlNode& item : list.items)
    out += std::string(2 * depth, ' ') + "- " + inline_text(item) + "\n";
  return out;
}

}  // namespace

std::string inline_text(const YamlNode& node) {
  std::string out;
  switch (node.kind) {
    case YamlNode::Kind::scalar: return scalar_text(node.scalar);
    case YamlNode::Kind::list:
      for (const YamlNode& item : node.items) out += (out.empty() ? "" : ", ") + inline_text(item);
      return "[" + out + "]";
    case YamlNode::Kind::mapping:
      for (const YamlEntry& entry : node.entries) {
        out += (out.empty() ? "" : ", ") + entry.key + ": " + inline_text(entry.value);
      }
      return "{" + out + "}";
    default: return "null";
  }
}

std::string double_quoted(std::string_view text) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += std::string("\\") + c;
    } else if (c == '\n') {
      out += "\\n";
    } else if (c == '\t') {
      out += "\\t";
    } else if (byte < 0x20 || byte == 0x7F) {
      out += std::string("\\x") + kDigits[byte >> 4U] + kDigits[byte & 0xFU];
    } else {
      out += c;
    }
  }
  return out + "\"";
}

std::string yaml_text(const YamlNode& mapping, std::size_t depth) {
  std::string out;
  for (const YamlEntry& entry : mapping.entries) {
    const YamlNode& value = entry.value;
    const std::string key = std::string(2 * depth, ' ') + entry.key + ":";
    const std::string line = inline_text(value);
    const bool short_enough = key.size() + line.size() < kLineLength;
    const bool of_mappings = value.kind == YamlNode::Kind::list && !value.items.empty() &&
                             value.items.front().kind == YamlNode::Kind::mapping;
    if (value.kind == YamlNode::Kind::mapping && (is_deep(value) || !short_enough)) {
      out += key + "\n" + yaml_text(value, depth + 1);
    } else if (value.kind == YamlNode::Kind::list && (of_mappings || !short_enough)) {
      out += key + "\n" + item_lines(value, depth + 1);
    } else {
      out += key + " " + line + "\n";
    }
  }
  return out;
}

}  // namespace twum::inline v0_1::io
