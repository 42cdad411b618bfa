// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "motor/given_motor.hpp"

#include <twum/studies/schema/shape.hpp>

namespace twum::studies {

/// `support`, which says what holds the inner edge of the plate.
Field<GivenMotor> support_field();

/// `material`, whose values stand for entries that are left out.
/// @param block  such as "stator.geometry.substrate"
Field<GivenMotor> material_field(std::string_view block);

/// True if a block may name a material.
bool has_material(std::string_view block);

/// True if materials of the block's kind give the entry of a parameter.
bool material_gives(const ParameterInfo& row);

/// What holds if an entry of the geometry is left out, in words; empty if it may not be.
std::string geometry_fallback(Parameter parameter);

/// Says what is wrong with a motor whose entries are right one by one: "NAME must ..., but ..." at the entry of that name, all
/// else at the geometry.
void say_of_motor(const std::string& text, const Given& motor, Diagnostics& diagnostics);

/// Gives the entries of a block that its material has and the file leaves out.
void fill_from_material(GivenMotor& motor, std::string_view block);

/// Says which entries of the stator follow from its geometry already; false if any.
bool check_geometry_alone(const Given& stator, Diagnostics& diagnostics);

/// The geometry without its numbers: the blocks that are given; nothing if none is.
std::optional<stator::StatorGeometry> blank_geometry(const GivenMotor& given);

}  // namespace twum::studies
