// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/diagnostics/diagnostics.hpp>
#include <twum/studies/yaml/node.hpp>

namespace twum::studies {

/// Adds what is wrong between the entries of a sensitivity study: those that its method has no use for.
void check_sensitivity(const YamlNode& study, Diagnostics& diagnostics);

/// Adds what is wrong in the distributions of an uncertainty study, and probabilities that repeat.
void check_uncertainty(const YamlNode& study, Diagnostics& diagnostics);

}  // namespace twum::studies
