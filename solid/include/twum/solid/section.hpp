// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/solid/eigenmodes.hpp>

#include <array>
#include <string_view>
#include <vector>

namespace twum::inline v0_1::solid {

/// A part of a stator in its cross-section: a rectangle. Heights are above the bottom of the metal.
struct SectionPart {
  std::string_view name;  ///< "ring", "web", "teeth", "ceramic" or "glue"; static lifetime
  Part part;              ///< what it is made of
  double inner;           ///< [m]
  double outer;           ///< [m]
  double bottom;          ///< [m]
  double top;             ///< [m]
};

/// The cross-section of a stator as make_sector() takes it, each part once.
std::vector<SectionPart> cross_section(const stator::StatorGeometry& geometry,
                                       double contact_radius);

/// A brick's face in the cross-section through a tooth.
struct BentFace {
  using Points = std::array<std::array<double, 2>, 4>;  ///< radius and height of the corners

  Part part;      ///< what it is made of
  Points place;   ///< at rest [m]
  Points motion;  ///< at the crest of the wave, over the axial motion at the contact radius [1]
};

/// The cross-section through a tooth at the crest of the wave.
std::vector<BentFace> bent_section(const Sector& sector, int nodal_diameters, double contact_radius,
                                   const Eigenmode& mode);

}  // namespace twum::inline v0_1::solid
