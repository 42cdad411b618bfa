// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/io/diagnostics.hpp>
#include <twum/io/yaml_node.hpp>

namespace twum::inline v0_1::io {

/// Parses the text of the diagnostics' source into a tree and refuses what a strict file must not contain. The bytes
/// must be valid text. The root is of kind refused after a syntax error.
YamlNode build_tree(Diagnostics& diagnostics);

}  // namespace twum::inline v0_1::io
