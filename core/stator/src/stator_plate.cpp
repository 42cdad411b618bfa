// SPDX-License-Identifier: Apache-2.0
#include "stator_plate.hpp"

#include <cmath>

namespace twum::inline v0_1::stator {
namespace {

// Radii closer than this share of the plate's outer radius are the same place.
constexpr double kSamePlace = 1e-9;

struct Edge {
  Dimension dimension;
  double radius;
};

// A web that begins inside the substrate's inner radius continues the plate, so that radius is not an edge.
bool web_covers_inner_radius(const StatorGeometry& g) {
  return g.web && g.web->inner_radius <= g.substrate.inner_radius;
}

std::vector<Edge> all_edges(const StatorGeometry& g) {
  using enum Dimension;
  std::vector<Edge> edges;
  for (const Dimension dimension :
       {substrate_inner_radius, substrate_outer_radius, web_inner_radius, web_outer_radius,
        teeth_inner_radius, teeth_outer_radius, ceramic_inner_radius, ceramic_outer_radius,
        electrodes_inner_radius, electrodes_outer_radius}) {
    if (dimension == substrate_inner_radius && web_covers_inner_radius(g)) continue;
    if (const double* radius = find(g, dimension)) edges.push_back({dimension, *radius});
  }
  std::stable_sort(edges.begin(), edges.end(),
                   [](const Edge& a, const Edge& b) { return a.radius < b.radius; });
  return edges;
}

Numbers<double> given_numbers(const StatorGeometry& geometry, double contact_radius) {
  Numbers<double> numbers{};
  for (std::size_t i = 0; i < kDimensions; ++i) {
    if (const double* value = find(geometry, static_cast<Dimension>(i))) numbers.values[i] = *value;
  }
  numbers[Dimension::contact_radius] = contact_radius;
  return numbers;
}

// Electrodes without radii of their own have the ceramic's.
template <typename S>
Numbers<S> with_electrodes(const StatorGeometry& geometry, Numbers<S> numbers) {
  using enum Dimension;
  const Electrodes& electrodes = geometry.electrodes;
  if (!electrodes.inner_radius) numbers[electrodes_inner_radius] = numbers[ceramic_inner_radius];
  if (!electrodes.outer_radius) numbers[electrodes_outer_radius] = numbers[ceramic_outer_radius];
  return numbers;
}

}  // namespace

Numbers<double> plain_numbers(const StatorGeometry& geometry, double contact_radius) {
  return with_electrodes(geometry, given_numbers(geometry, contact_radius));
}

Numbers<Derived> dual_numbers(const StatorGeometry& geometry, double contact_radius) {
  const Numbers<double> given = given_numbers(geometry, contact_radius);
  Numbers<Derived> numbers;
  for (std::size_t i = 0; i < kDimensions; ++i) {
    numbers.values[i] = Derived::variable(given.values[i], static_cast<int>(i));
  }
  return with_electrodes(geometry, numbers);
}

Edges find_edges(const StatorGeometry& geometry) {
  const double tolerance = kSamePlace * geometry.substrate.outer_radius;
  Edges edges;
  const std::vector<Edge> all = all_edges(geometry);
  for (std::size_t first = 0, next = 0; first < all.size(); first = next) {
    Dimension chosen = all[first].dimension;
    for (next = first; next < all.size() && all[next].radius - all[first].radius <= tolerance;
         ++next) {
      chosen = std::min(chosen, all[next].dimension);
    }
    edges.radii.push_back(chosen);
    if (next - first < 2) continue;
    for (std::size_t i = first; i < next; ++i) edges.joint.push_back(all[i].dimension);
  }
  // At the end of the web that covers it, the substrate's inner radius may move to one side only.
  if (web_covers_inner_radius(geometry)) {
    for (const double end : {geometry.web->inner_radius, geometry.web->outer_radius}) {
      if (std::abs(geometry.substrate.inner_radius - end) <= tolerance) {
        edges.joint.push_back(Dimension::substrate_inner_radius);
      }
    }
  }
  std::sort(edges.joint.begin(), edges.joint.end());
  return edges;
}

}  // namespace twum::inline v0_1::stator
