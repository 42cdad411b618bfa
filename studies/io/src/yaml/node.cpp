// SPDX-License-Identifier: Apache-2.0
#include <twum/io/yaml_node.hpp>

namespace twum::inline v0_1::io {

const YamlNode* YamlNode::find(std::string_view key) const {
  for (const YamlEntry& entry : entries) {
    if (entry.key == key) return &entry.value;
  }
  return nullptr;
}

std::string_view kind_phrase(YamlNode::Kind kind) {
  switch (kind) {
    case YamlNode::Kind::empty: return "empty";
    case YamlNode::Kind::scalar: return "a text";
    case YamlNode::Kind::list: return "a list";
    case YamlNode::Kind::mapping: return "a mapping";
    case YamlNode::Kind::refused: break;
  }
  return "unreadable";
}

}  // namespace twum::inline v0_1::io
