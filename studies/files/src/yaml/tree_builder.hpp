// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/diagnostics/diagnostics.hpp>
#include <twum/studies/yaml/node.hpp>

namespace twum::studies {

/// Parses the text of the diagnostics' source into our tree and refuses what a strict file may not
/// have; the bytes are known to be text. Of kind refused if a syntax error ended it.
YamlNode build_tree(Diagnostics& diagnostics);

}  // namespace twum::studies
