// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/namespaces.hpp>
#include <twum/io/diagnostics.hpp>
#include <twum/io/yaml_node.hpp>

namespace twum::inline v0_1::io {

/// Reads one YAML document strictly: duplicate keys, keys that are not words, anchors, aliases, merge keys, tags,
/// further documents, deep nesting, and bytes that are not text are errors.
///
/// After a structural error, reading continues; a syntax error ends it. Both are added to the diagnostics, and
/// nothing is thrown. Time and memory are proportional to the length of the text for any content.
/// @return the root; of kind refused if nothing could be read.
YamlNode load_yaml(Diagnostics& diagnostics);

}  // namespace twum::inline v0_1::io
