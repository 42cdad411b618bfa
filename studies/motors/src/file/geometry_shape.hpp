// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "file/given_motor.hpp"

#include <twum/io/shape.hpp>

namespace twum::inline v0_1::motors {

/// `support`, which says what holds the inner edge of the plate.
Field<GivenMotor> support_field();

/// `material`, whose values replace entries that are left out.
/// @param block  such as "stator.geometry.substrate"
Field<GivenMotor> material_field(std::string_view block);

/// True if a block may name a material.
bool has_material(std::string_view block);

/// True if materials of the block's kind give the entry of a parameter.
bool material_gives(const ParameterInfo& row);

/// Adds an error for a motor whose single entries are valid. "NAME must ..., but ..." is reported at the entry of
/// that name, everything else at the geometry.
void say_of_motor(const std::string& text, const Given& motor, Diagnostics& diagnostics);

/// Sets the entries of a block that the file leaves out from its material.
void fill_from_material(GivenMotor& motor, std::string_view block);

/// Adds errors for entries of the stator that follow from its geometry; false if there are any.
bool check_geometry_alone(const Given& stator, Diagnostics& diagnostics);

/// The geometry with the given blocks, still without numbers; nothing if no block is given.
std::optional<stator::StatorGeometry> blank_geometry(const GivenMotor& given);

}  // namespace twum::inline v0_1::motors
