// SPDX-License-Identifier: Apache-2.0
#include "plate_mesh.hpp"
#include "quantity_text.hpp"

#include <twum/base/error.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace twum::inline v0_1::stator {
namespace {

// A function such as ln(rho) or rho^-n on a ring whose radii differ by a factor of 2 loses a factor of
// 5.8 with each degree: 1e-9 at degree 12, and the square of it in a frequency.
constexpr double kLargestRatio = 2;
constexpr int kDegree = 12;
// Elements narrower than this share of the plate contain little of a wave, so that a lower degree is sufficient.
constexpr double kNarrow = 0.1;
constexpr int kNarrowDegree = 7;

// Shares of a segment's width at which its elements begin and end: radii in a geometric sequence.
std::vector<double> element_edges(const Segment& segment) {
  const double ratio = segment.outer / segment.inner;
  const int count =
      std::max(1, static_cast<int>(std::ceil(std::log(ratio) / std::log(kLargestRatio) - 1e-9)));
  std::vector<double> edges{0.0};
  for (int i = 1; i < count; ++i) {
    edges.push_back((std::pow(ratio, static_cast<double>(i) / count) - 1) / (ratio - 1));
  }
  edges.push_back(1.0);
  return edges;
}

// Whether the support holds a function of the inner edge at zero.
bool held(InnerEdge edge, PlateTheory theory, int field, int function) {
  if (edge == InnerEdge::free) return false;
  if (edge == InnerEdge::clamped) return true;
  return theory == PlateTheory::mindlin ? field != 1 : function == 0;
}

// The functions of an element at the Gauss points; the tables are the same for all plates.
std::shared_ptr<const BasisTable> basis_of(PlateTheory theory, bool narrow) {
  const auto made = [](Continuity continuity, int degree) {
    return std::make_shared<const BasisTable>(make_table(continuity, degree));
  };
  static const std::array mindlin{made(Continuity::value, kDegree),
                                  made(Continuity::value, kNarrowDegree)};
  static const std::array kirchhoff{made(Continuity::slope, kDegree),
                                    made(Continuity::slope, kNarrowDegree)};
  return (theory == PlateTheory::mindlin ? mindlin : kirchhoff)[narrow ? 1 : 0];
}

// Numbers the functions of an element; those of its inner end are the outer ones of the element before. The outer end comes last:
// eliminated in this order, nothing that ends in an element touches the elements beyond it.
std::vector<std::vector<int>> number_functions(Mesh& mesh, const Basis& basis,
                                               const Element* before, InnerEdge inner_edge) {
  const auto fields = static_cast<std::size_t>(mesh.fields());
  const auto size = static_cast<std::size_t>(basis.size());
  const auto end = static_cast<std::size_t>(basis.at_end());
  std::vector<std::vector<int>> dofs(fields, std::vector<int>(size, -1));
  for (std::size_t field = 0; field < fields; ++field) {
    for (std::size_t i = 0; i < end; ++i) {
      if (before)
        dofs[field][i] = before->dofs[field][end + i];
      else if (!held(inner_edge, mesh.theory, static_cast<int>(field), static_cast<int>(i)))
        dofs[field][i] = mesh.unknowns++;
    }
    for (std::size_t i = 2 * end; i < size; ++i) dofs[field][i] = mesh.unknowns++;
  }
  for (std::size_t field = 0; field < fields; ++field)
    for (std::size_t i = end; i < 2 * end; ++i) dofs[field][i] = mesh.unknowns++;
  return dofs;
}

// Narrowest rings, as a share of the plate's width. Rounding errors of the stiffness grow with the inverse share:
// with its cube for Kirchhoff's Hermite functions, linearly for Mindlin's functions. These limits leave an accuracy
// of 1e-7 or better.
constexpr double kNarrowestKirchhoff = 1e-3;
constexpr double kNarrowestMindlin = 1e-9;

void check_widths(const std::vector<Segment>& segments, PlateTheory theory) {
  const bool mindlin = theory == PlateTheory::mindlin;
  const double narrowest = (mindlin ? kNarrowestMindlin : kNarrowestKirchhoff) *
                           (segments.back().outer - segments.front().inner);
  for (const Segment& segment : segments) {
    if (segment.outer - segment.inner >= narrowest) continue;
    throw InputError("plate: the ring from " + quantity_text(segment.inner, "m") + " is only " +
                     quantity_text(segment.outer - segment.inner, "m") + " wide; " +
                     (mindlin ? "Mindlin" : "Kirchhoff") + "'s plate needs " +
                     quantity_text(narrowest, "m") +
                     " or more. Give its two edges the same radius" +
                     (mindlin ? "" : ", or choose Mindlin's plate"));
  }
}

}  // namespace

Mesh make_mesh(const std::vector<Segment>& segments, PlateTheory theory, InnerEdge inner_edge,
               int nodal_diameters) {
  check_widths(segments, theory);
  Mesh mesh{theory, nodal_diameters, 0, {}};
  const double width = segments.back().outer - segments.front().inner;
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const auto edges = element_edges(segments[s]);
    for (std::size_t e = 0; e + 1 < edges.size(); ++e) {
      const double share =
          (edges[e + 1] - edges[e]) * (segments[s].outer - segments[s].inner) / width;
      const auto table = basis_of(theory, share < kNarrow);
      const Element* before = mesh.elements.empty() ? nullptr : &mesh.elements.back();
      auto dofs = number_functions(mesh, table->basis, before, inner_edge);
      mesh.elements.push_back({s, edges[e], edges[e + 1], table, std::move(dofs)});
    }
  }
  return mesh;
}

}  // namespace twum::inline v0_1::stator
