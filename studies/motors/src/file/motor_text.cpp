// SPDX-License-Identifier: Apache-2.0
#include <twum/motors/motor_file.hpp>

#include "yaml/yaml_text.hpp"

namespace twum::inline v0_1::motors {
namespace {

std::string in_line(const YamlNode& node) {
  return node.kind == YamlNode::Kind::list ? inline_text(node) : node.scalar;
}

// Every entry on a line of its own.
std::string lines_of(const YamlNode& mapping, const std::string& indent) {
  std::string text;
  for (const YamlEntry& entry : mapping.entries) {
    const bool section = entry.value.kind == YamlNode::Kind::mapping;
    text += indent + entry.key + ":";
    text +=
        section ? "\n" + lines_of(entry.value, indent + "  ") : " " + in_line(entry.value) + "\n";
  }
  return text;
}

}  // namespace

std::string motor_text(const MotorFile& motor) {
  YamlNode file = motor_file_shape().write(motor);
  for (YamlEntry& entry : file.entries.back().value.entries)
    if (entry.key == "name") entry.value.scalar = double_quoted(entry.value.scalar);
  return lines_of(file, "");
}

}  // namespace twum::inline v0_1::motors
