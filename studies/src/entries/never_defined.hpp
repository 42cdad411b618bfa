// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motor_design.hpp>
#include <twum/io/diagnostics.hpp>
#include <twum/io/yaml_node.hpp>
#include <twum/studies/study.hpp>

#include <string>
#include <vector>

namespace twum::inline v0_1::studies {

/// Adds an error for each variable that the motor cannot have and for each metric that none of its motors has: those that need
/// modal data, a geometry, a sensor or a voltage that nothing gives.
void check_defined(const Study& study, const MotorDesign& motor, const YamlNode& root,
                   Diagnostics& diagnostics);

/// Notes on ends of ranges beyond the ones in which the solver is tested, each with its line and, if another prefix would make it
/// usual, the unit that may be meant.
std::vector<std::string> range_notes(const Study& study, const MotorDesign& motor,
                                     const YamlNode& study_node, const std::string& path);

}  // namespace twum::inline v0_1::studies
