// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/solid/sector.hpp>

#include <string>

namespace twum::inline v0_1::solid {

/// Text of the input file with which CalculiX finds the modes of a stator with n nodal diameters by cyclic symmetry.
///
/// The inner edge is free, held at all its nodes (clamped), or held along the axis and round the circumference
/// (supported). CalculiX prints the motion of all nodes, and writes it for a viewer of its own too.
/// @param nodal_diameters  n, 0 to most_nodal_diameters()
/// @param modes            how many modes are wanted; with n > 0 each counts twice
std::string deck_text(const Sector& sector, const stator::StatorGeometry& geometry,
                      int nodal_diameters, int modes);

}  // namespace twum::inline v0_1::solid
