// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/diagnostics/diagnostics.hpp>
#include <twum/studies/yaml/node.hpp>

namespace twum::studies {

/// Most designs of one sweep.
inline constexpr double kMostDesigns = 1e9;

/// Adds where the entries of a sweep do not fit its sampling: lists of different lengths, `points`
/// where nothing is a grid, `samples` where nothing is drawn, grid points between whole numbers.
void check_sweep(const YamlNode& study, Diagnostics& diagnostics);

/// A valid sweep with the defaults that depend on its sampling written out.
YamlNode with_sweep_defaults(YamlNode study);

}  // namespace twum::studies
