// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "design/layer_properties.hpp"

#include <twum/base/dual.hpp>
#include <twum/core/parameters.hpp>

namespace twum::inline v0_1 {

/// @name Numbers of the thermal network, given or from the stator's geometry and materials (H1.7 to H1.9); NaN where neither is.
/// Through the web, whose inner edge is clamped, to the housing; through the teeth to the contact; of metal, glue and ceramic.
/// @{
double stator_housing_conductance(const MotorDesign& design);
double stator_contact_conductance(const MotorDesign& design);
double stator_heat_capacity(const MotorDesign& design);
/// @}

/// Sets those that follow from the others.
void add_stator_heat(const MotorDesign& given, ParameterArray<Dual<double, 1>>& values);

}  // namespace twum::inline v0_1
