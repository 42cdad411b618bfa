// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/io/yaml_node.hpp>

#include <string>
#include <string_view>

namespace twum::inline v0_1::io {

/// A text in quotation marks with escaped control characters; load_yaml() reads back the same text.
std::string double_quoted(std::string_view text);

/// A node in one line, likewise.
std::string inline_text(const YamlNode& node);

/// The entries of a mapping as lines of YAML, which load_yaml() reads back as they are.
std::string yaml_text(const YamlNode& mapping, std::size_t depth);

}  // namespace twum::inline v0_1::io
