// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motor_design.hpp>
#include <twum/io/diagnostics.hpp>
#include <twum/io/yaml_node.hpp>
#include <twum/studies/study.hpp>

namespace twum::inline v0_1::studies {

/// Adds an error for each entry of a motion that its motor cannot follow.
void check_motion(const Study& study, const MotorDesign& motor, const YamlNode& root,
                  Diagnostics& diagnostics);

}  // namespace twum::inline v0_1::studies
