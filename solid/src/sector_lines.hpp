// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/solid/sector.hpp>

#include <optional>
#include <vector>

namespace twum::inline v0_1::solid {

/// A layer of the stator at one radius. Heights are above the bottom of the metal.
struct SolidLayer {
  double bottom;  ///< [m]
  double top;     ///< [m]
  Part part;      ///< what it is made of
  bool toothed;   ///< cut by the slots
};

/// Layers at a radius that is not an edge, from the bottom to the top.
/// @param web_bottom  height of the web's bottom [m]
std::vector<SolidLayer> solid_layers(const stator::StatorGeometry& geometry, double web_bottom,
                                     double radius);

/// Height of the web's bottom, see make_sector() [m]; 0 without a web.
double web_bottom_of(const stator::StatorGeometry& geometry, double contact_radius);

/// Radii between the bricks, from the inside [m].
std::vector<double> radial_lines(const stator::StatorGeometry& geometry, double contact_radius,
                                 double size);

/// Heights between the bricks, from the bottom [m].
std::vector<double> axial_lines(const stator::StatorGeometry& geometry, double web_bottom,
                                const std::vector<double>& radii, double size);

/// Where the metal begins [m].
double inner_radius(const stator::StatorGeometry& geometry);

/// True if slots cut the stator into teeth.
bool has_slots(const stator::StatorGeometry& geometry);

}  // namespace twum::inline v0_1::solid
