// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "study/entry_shapes.hpp"

#include <twum/core/design/motor_design.hpp>
#include <twum/studies/problem/tolerance.hpp>

#include <string>
#include <vector>

namespace twum::studies::shapes {

/// Tolerances by parameter: `preload: 3 %`, or a mapping with the distribution.
Shape<std::vector<Tolerance>> tolerances(std::string text);

/// Says what is wrong with tolerances once the design is known.
/// @param mapping  what stands for them in the file, at `path`
void check_tolerances(const std::vector<Tolerance>& tolerances, const MotorDesign& design,
                      const YamlNode& mapping, const std::string& path, Diagnostics& diagnostics);

/// Says which tolerances are not about the design's own value, a sentence each.
std::vector<std::string> tolerance_notes(const std::vector<Tolerance>& tolerances,
                                         const MotorDesign& design);

}  // namespace twum::studies::shapes
