// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace twum::test {

/// An isotropic solid.
struct Solid {
  double youngs_modulus;  ///< [Pa]
  double poisson_ratio;   ///< [1]
  double density;         ///< [kg/m^3]
};

/// A sector of a body of revolution, or of one with teeth, in bricks between lines of constant radius and
/// height. All bricks have the same division along the circumference: half a slot, the tooth in `tooth_bricks`
/// parts, half a slot.
struct SolidSector {
  int sectors;                  ///< how many make the whole body
  double slot_width;            ///< constant along the radius [m]
  int tooth_bricks;             ///< parts of the tooth along the circumference
  std::vector<double> radii;    ///< lines [m]
  std::vector<double> heights;  ///< lines [m]
  std::vector<Solid> solids;
  /// Which solid fills a brick between lines i and i + 1, j and j + 1, and whether only the tooth does; -1 for
  /// none. As a table [i][j].
  struct Fill {
    int solid{-1};
    bool tooth_only{false};
  };
  std::vector<std::vector<Fill>> fill;
  bool clamped{false};        ///< at the smallest radius
  double reference_radius{};  ///< one of the lines, where the motion is looked at [m]
};

/// A bending mode of the solid.
struct SolidMode {
  double frequency;   ///< [Hz]
  double modal_mass;  ///< of cos(n phi) for the mean axial motion at the reference radius [kg]
  double tangential;  ///< tangential over axial motion of the top at the reference radius [1]
};

/// Bending modes with n > 0 nodal diameters by CalculiX (quadratic bricks C3D20R, cyclic symmetry), lowest first:
/// of the modes asked for, those that move the nodes more along the axis than within the plane.
/// @param modes  how many CalculiX looks for; every mode comes twice
/// @throws std::runtime_error if the program ccx is missing or fails
std::vector<SolidMode> bending_modes(const SolidSector& sector, int nodal_diameters, int modes);

}  // namespace twum::test
