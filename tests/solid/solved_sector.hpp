// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/solid/eigenmodes.hpp>

#include <vector>

namespace twum::test {

/// Modes of a sector with n nodal diameters by CalculiX.
/// @param modes  how many CalculiX looks for; every mode comes twice
/// @throws std::runtime_error if the program ccx is missing or fails
std::vector<solid::Eigenmode> calculix_modes(const solid::Sector& sector,
                                             const stator::StatorGeometry& geometry, int n,
                                             int modes);

/// Those that bend the stator: more of their motion is along the axis than within the plane.
std::vector<solid::Eigenmode> bending_modes(const solid::Sector& sector,
                                            const stator::StatorGeometry& geometry, int n,
                                            int modes, double contact_radius);

/// A plate of one material that carries a ceramic without stiffness or mass: a millionth of the metal's.
stator::StatorGeometry metal_plate(double inner_radius, double outer_radius, double thickness,
                                   stator::InnerEdge support);

}  // namespace twum::test
