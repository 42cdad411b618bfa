// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/io/diagnostics.hpp>
#include <twum/io/yaml_node.hpp>
#include <twum/studies/study.hpp>

#include <optional>
#include <vector>

namespace twum::inline v0_1::studies {

/// Another radius of the stator's geometry that is equal to a given one and does not follow from it; nothing if there is none. To move
/// one of the two alone makes an edge of its own, or a stator that cannot be.
std::optional<Parameter> equal_radius(const MotorDesign& design, Parameter radius,
                                      const std::vector<DerivedParameter>& derived);

/// Adds errors for variables of a gradient-based study that have no derivative in a motor with a geometry: the number
/// of wavelengths, and a radius that starts at the value of another one and is not derived from it.
/// @param root  root of the study's file
void check_plate_derivatives(const Study& study, const MotorDesign& motor, const YamlNode& root,
                             Diagnostics& diagnostics);

}  // namespace twum::inline v0_1::studies
