// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/diagnostics/diagnostics.hpp>
#include <twum/studies/yaml/node.hpp>

namespace twum::studies {

/// Adds what only a look at several entries of a study shows: empty ranges, logarithmic ranges that
/// touch zero, a family over two parameters.
void check_study(const YamlNode& study, Diagnostics& diagnostics);

}  // namespace twum::studies
