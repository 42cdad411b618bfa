// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/stator/geometry.hpp>
#include <twum/stator/plate.hpp>

#include <algorithm>
#include <array>
#include <numbers>
#include <vector>

namespace twum::inline v0_1::stator {

/// The dimensions of a geometry in numbers of the kind S; those of absent blocks are 0.
template <typename S>
struct Numbers {
  std::array<S, kDimensions> values;
  const S& operator[](Dimension dimension) const {
    return values[static_cast<std::size_t>(dimension)];
  }
  S& operator[](Dimension dimension) { return values[static_cast<std::size_t>(dimension)]; }
};

Numbers<double> plain_numbers(const StatorGeometry& geometry, double contact_radius);

/// The same numbers, each an independent variable. Electrodes without radii of their own move with the ceramic.
Numbers<Derived> dual_numbers(const StatorGeometry& geometry, double contact_radius);

/// Radii at which the plate's section changes or an electrode ends, from the inside to the outside.
struct Edges {
  std::vector<Dimension> radii;  ///< one for each distinct radius
  std::vector<Dimension> joint;  ///< all that coincide with another one
};

Edges find_edges(const StatorGeometry& geometry);

/// A stator as a plate.
template <typename S>
struct StatorPlate {
  std::vector<SegmentOf<S>> segments;
  std::vector<S> levers;         ///< z_p, mid-plane of the ceramic from the neutral plane [m]
  std::vector<S> faces;          ///< the ceramic's face that is farthest from the neutral plane; 0
                                 ///< without ceramic [m]
  std::vector<S> tooth_heights;  ///< 0 where there are no teeth [m]
  std::vector<bool> electrodes;  ///< whether the segment is covered
};

/// Share of metal in a ring of teeth. Its mean over the ring's area is its value at the middle radius (P1.8).
template <typename S>
S tooth_fill(const Numbers<S>& x, int count) {
  const S circumference =
      std::numbers::pi * (x[Dimension::teeth_inner_radius] + x[Dimension::teeth_outer_radius]);
  return 1.0 - static_cast<double>(count) * x[Dimension::teeth_slot_width] / circumference;
}

/// Layers at a radius that is not an edge, from the bottom to the top.
template <typename S>
std::vector<LayerOf<S>> layers_at(const StatorGeometry& g, const Numbers<S>& x, double radius) {
  using enum Dimension;
  const auto within = [&](Dimension inner, Dimension outer) {
    return radius > value_of(x[inner]) && radius < value_of(x[outer]);
  };
  std::vector<LayerOf<S>> layers;
  if (within(ceramic_inner_radius, ceramic_outer_radius)) {
    layers.push_back({x[ceramic_thickness], x[ceramic_youngs_modulus], x[ceramic_poisson_ratio],
                      x[ceramic_density]});
    layers.push_back(
        {x[glue_thickness], x[glue_youngs_modulus], x[glue_poisson_ratio], x[glue_density]});
  }
  const bool in_web = g.web && within(web_inner_radius, web_outer_radius);
  const S& modulus = x[substrate_youngs_modulus];
  const S& nu = x[substrate_poisson_ratio];
  layers.push_back(
      {in_web ? x[web_thickness] : x[substrate_thickness], modulus, nu, x[substrate_density]});
  if (g.teeth && within(teeth_inner_radius, teeth_outer_radius)) {
    const S fill = tooth_fill(x, g.teeth->count);
    layers.push_back(
        {x[teeth_height], modulus * x[teeth_stiffness_share], nu, x[substrate_density] * fill});
  }
  return layers;
}

template <typename S>
StatorPlate<S> make_plate(const StatorGeometry& g, const Numbers<S>& x) {
  using enum Dimension;
  StatorPlate<S> plate;
  const Edges edges = find_edges(g);
  for (std::size_t i = 0; i + 1 < edges.radii.size(); ++i) {
    const S& inner = x[edges.radii[i]];
    const S& outer = x[edges.radii[i + 1]];
    const double middle = 0.5 * (value_of(inner) + value_of(outer));
    const SectionOf<S> section = section_of(layers_at(g, x, middle));
    const bool toothed = g.teeth && middle > value_of(x[teeth_inner_radius]) &&
                         middle < value_of(x[teeth_outer_radius]);
    plate.tooth_heights.push_back(toothed ? x[teeth_height] : S(0.0));
    plate.levers.push_back(0.5 * x[ceramic_thickness] - section.neutral_plane);
    const bool covered =
        middle > value_of(x[ceramic_inner_radius]) && middle < value_of(x[ceramic_outer_radius]);
    const bool low = value_of(plate.levers.back()) < 0;
    plate.faces.push_back(!covered ? S(0.0)
                          : low    ? S(-section.neutral_plane)
                                   : S(x[ceramic_thickness] - section.neutral_plane));
    plate.electrodes.push_back(middle > value_of(x[electrodes_inner_radius]) &&
                               middle < value_of(x[electrodes_outer_radius]));
    plate.segments.push_back({inner, outer, section});
  }
  return plate;
}

/// The segment that contains a radius; on an edge, the outer one.
template <typename S>
std::size_t segment_at(const StatorPlate<S>& plate, double radius) {
  std::size_t i = 0;
  while (i + 1 < plate.segments.size() && radius >= value_of(plate.segments[i].outer)) ++i;
  return i;
}

}  // namespace twum::inline v0_1::stator
