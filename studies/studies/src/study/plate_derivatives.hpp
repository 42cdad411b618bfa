// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/diagnostics/diagnostics.hpp>
#include <twum/studies/study/study.hpp>
#include <twum/studies/yaml/node.hpp>

namespace twum::studies {

/// Says which variables of a study that takes derivatives have none beside a geometry of the stator: a radius that begins where
/// another one stands, which is not derived from it, and the number of wavelengths.
/// @param root  of the study's file
void check_plate_derivatives(const Study& study, const MotorDesign& motor, const YamlNode& root,
                             Diagnostics& diagnostics);

}  // namespace twum::studies
