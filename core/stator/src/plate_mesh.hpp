// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "polynomials.hpp"

#include <twum/stator/plate.hpp>

#include <memory>
#include <vector>

namespace twum::inline v0_1::stator {

/// A ring of a segment with polynomials of its own. Its position relative to the segment is fixed, so that elements
/// follow the segment's radii.
struct Element {
  std::size_t segment;
  double from;                              ///< share of the segment's width
  double to;                                ///< share of the segment's width
  std::shared_ptr<const BasisTable> table;  ///< shared by elements of the same degree
  std::vector<std::vector<int>> dofs;  ///< [field][function]; -1 where the support holds it at zero
};

/// The discrete plate for one number of nodal diameters: everything except radii and sections.
struct Mesh {
  PlateTheory theory;
  int nodal_diameters;
  int unknowns{0};
  std::vector<Element> elements;

  /// R alone (Kirchhoff); R, psi_r and, unless n = 0, psi_t (Mindlin).
  int fields() const { return theory == PlateTheory::kirchhoff ? 1 : nodal_diameters == 0 ? 2 : 3; }
};

/// @throws InputError for a ring too narrow for rounding: 1e-9 of the plate's width (Mindlin), 1e-3
/// (Kirchhoff)
Mesh make_mesh(const std::vector<Segment>& segments, PlateTheory theory, InnerEdge inner_edge,
               int nodal_diameters);

}  // namespace twum::inline v0_1::stator
