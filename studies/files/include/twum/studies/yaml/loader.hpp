// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/diagnostics/diagnostics.hpp>
#include <twum/studies/yaml/node.hpp>

namespace twum::studies {

/// Reads one YAML document, strictly: duplicate keys, keys that are not words, anchors, aliases, merge
/// keys, tags, further documents, deep nesting, and bytes that are no text are errors.
///
/// Wrong structure is added to the diagnostics and reading goes on; a syntax error ends it. Time and memory
/// are proportional to the text, whatever it holds. Never throws for it.
/// @return the root; of kind refused if nothing could be read.
YamlNode load_yaml(Diagnostics& diagnostics);

}  // namespace twum::studies
