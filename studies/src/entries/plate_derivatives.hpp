// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/io/diagnostics.hpp>
#include <twum/io/yaml_node.hpp>
#include <twum/studies/study.hpp>

namespace twum::studies {

/// Adds errors for variables of a gradient-based study that have no derivative in a motor with a geometry: the number
/// of wavelengths, and a radius that starts at the value of another one and is not derived from it.
/// @param root  root of the study's file
void check_plate_derivatives(const Study& study, const MotorDesign& motor, const YamlNode& root,
                             Diagnostics& diagnostics);

}  // namespace twum::studies
