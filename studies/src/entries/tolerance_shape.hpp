// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "entries/entry_shapes.hpp"

#include <twum/core/motor_design.hpp>
#include <twum/studies/tolerance.hpp>

#include <string>
#include <vector>

namespace twum::inline v0_1::studies::shapes {

/// Tolerances by parameter: `preload: 3 %`, or a mapping with the distribution.
Shape<std::vector<Tolerance>> tolerances(std::string text);

/// Parameters that scatter together: `[[preload, kinetic_friction, 0.7], ...]`.
Shape<std::vector<ToleranceCorrelation>> correlations();

/// Adds an error for a correlation of a parameter without a tolerance, and for one that contradicts the others.
/// @param of  the entry with the tolerances
void check_correlations(const std::vector<Tolerance>& tolerances,
                        const std::vector<ToleranceCorrelation>& correlations, const Given& given,
                        const std::string& of, Diagnostics& diagnostics);

/// Adds errors for tolerances that do not fit the design.
/// @param mapping  the mapping of tolerances in the file, at `path`
void check_tolerances(const std::vector<Tolerance>& tolerances, const MotorDesign& design,
                      const YamlNode& mapping, const std::string& path, Diagnostics& diagnostics);

/// Notes on tolerances that are not centred at the design's value, one sentence each.
std::vector<std::string> tolerance_notes(const std::vector<Tolerance>& tolerances,
                                         const MotorDesign& design);

}  // namespace twum::inline v0_1::studies::shapes
