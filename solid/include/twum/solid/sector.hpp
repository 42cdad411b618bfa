// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/stator/geometry.hpp>

#include <array>
#include <vector>

namespace twum::inline v0_1::solid {

/// What a brick is made of.
enum class Part : unsigned char {
  metal,    ///< substrate, web and teeth
  ceramic,  ///< of the isotropic stiffness of the plate model
  glue      ///< between the two
};

/// How many parts there are.
inline constexpr int kParts = 3;

/// A place in the grid of a sector: along radius, circumference and axis, counted in half bricks.
using Place = std::array<int, 3>;

/// A node of the mesh, in cylindrical coordinates.
struct SectorNode {
  Place place;    ///< in the grid
  double radius;  ///< [m]
  double angle;   ///< from the middle of the sector [rad]
  double height;  ///< above the bottom of the metal [m]
};

/// A brick with 20 nodes (CalculiX's C3D20R).
struct SectorBrick {
  Place place;                ///< of its first corner
  std::array<int, 20> nodes;  ///< indices of its nodes: 8 corners, then the middles of 12 edges
  Part part;                  ///< what it is made of
};

/// A sector of a stator in bricks: one tooth with half a slot on each side, or a narrow part of a stator without teeth.
struct Sector {
  int count{};                      ///< sectors that make the whole stator
  int around{};                     ///< bricks along the circumference
  std::vector<double> radii;        ///< of the lines between the bricks, from the inside [m]
  std::vector<SectorNode> nodes;    ///< of all bricks
  std::vector<SectorBrick> bricks;  ///< all of the sector

  /// Angle of a sector [rad].
  double pitch() const;
};

/// Most elements through the plate that make_sector() takes.
inline constexpr int kMostElements = 12;

/// Divides a sector of a stator into bricks.
///
/// Lines run along all edges of the geometry and along the contact radius. Between them a brick is at most about as long as the
/// substrate is thick, over `elements`; the glue is one brick thick. The geometry does not tell how high the web lies. Its
/// middle is put at the height of the neutral plane at the contact radius, without teeth, as near as the metal's
/// thickness allows; a web that carries ceramic is flush with the bottom.
/// @param wavelengths     n of the wave: a stator without teeth is cut into sectors for it
/// @param contact_radius  r, a line of the mesh [m]
/// @param elements        through the thickness of the substrate, 1 to kMostElements
/// @throws InputError as stator::check_geometry(); for a contact radius that is not on the plate, and for teeth of which two or
///          fewer stand on a wavelength
Sector make_sector(const stator::StatorGeometry& geometry, int wavelengths, double contact_radius,
                   int elements);

/// The largest number of nodal diameters that a division into sectors tells from others.
int most_nodal_diameters(const Sector& sector);

/// Corners, then middles of edges, of a brick with 20 nodes, in half bricks from its first corner.
const std::array<Place, 20>& brick_places();

}  // namespace twum::inline v0_1::solid
