// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/namespaces.hpp>
#include <twum/io/source.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace twum::inline v0_1::io {

struct YamlEntry;

/// A YAML value with its place. Scalars stay text; the schema gives them a meaning.
struct YamlNode {
  /// What stands there.
  enum class Kind : unsigned char {
    empty,   ///< nothing, "~" or "null"
    scalar,  ///< one word or text
    list,
    mapping,
    refused  ///< already reported as wrong, so no further errors are added
  };

  Kind kind{Kind::empty};          ///< what stands there
  SourceMark mark;                 ///< where it begins
  std::string scalar;              ///< the text, as in the file
  std::vector<YamlNode> items;     ///< of a list
  std::vector<YamlEntry> entries;  ///< of a mapping, in the order of the file, each key once

  /// The value of a key of a mapping; null if it has none.
  const YamlNode* find(std::string_view key) const;
};

/// One "key: value" of a mapping.
struct YamlEntry {
  std::string key;      ///< its name
  SourceMark key_mark;  ///< where the name begins
  YamlNode value;       ///< what it is
};

/// Name of a kind in error texts: "a text", "a list", ... Static lifetime.
std::string_view kind_phrase(YamlNode::Kind kind);

}  // namespace twum::inline v0_1::io
