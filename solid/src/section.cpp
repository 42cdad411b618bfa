// SPDX-License-Identifier: Apache-2.0
#include <twum/solid/section.hpp>

#include "sector_lines.hpp"
#include "surface.hpp"

#include <complex>

namespace twum::inline v0_1::solid {
namespace {

// Nodes of the first face along the circumference, round about.
constexpr std::array<std::size_t, 4> kFirstFace{0, 1, 5, 4};

BentFace face_of(const Sector& sector, int n, const SectorBrick& brick, const Eigenmode& mode,
                 std::complex<double> contact) {
  BentFace face{brick.part, {}, {}};
  for (std::size_t k = 0; k < kFirstFace.size(); ++k) {
    const auto index = static_cast<std::size_t>(brick.nodes[kFirstFace[k]]);
    const SectorNode& node = sector.nodes[index];
    const auto crest = std::polar(1.0, -n * node.angle) / contact;
    face.place[k] = {node.radius, node.height};
    face.motion[k] = {(crest * mode.motion[index][0]).real(),
                      (crest * mode.motion[index][2]).real()};
  }
  return face;
}

}  // namespace

std::vector<SectionPart> cross_section(const stator::StatorGeometry& g, double contact_radius) {
  const double web_bottom = web_bottom_of(g, contact_radius);
  const double ring = g.web ? g.web->outer_radius : g.substrate.inner_radius;
  const double thickness = g.substrate.thickness, glue = g.glue.thickness;
  std::vector<SectionPart> parts;
  if (g.web)
    parts.push_back({"web", Part::metal, g.web->inner_radius, g.web->outer_radius, web_bottom,
                     web_bottom + g.web->thickness});
  if (g.web && g.web->inner_radius > g.substrate.inner_radius)
    parts.push_back(
        {"ring", Part::metal, g.substrate.inner_radius, g.web->inner_radius, 0, thickness});
  parts.push_back({"ring", Part::metal, ring, g.substrate.outer_radius, 0, thickness});
  if (g.teeth)
    parts.push_back({"teeth", Part::metal, g.teeth->inner_radius, g.teeth->outer_radius, thickness,
                     thickness + g.teeth->height});
  const double inner = g.ceramic.inner_radius, outer = g.ceramic.outer_radius;
  if (glue > 0) parts.push_back({"glue", Part::glue, inner, outer, -glue, 0});
  parts.push_back({"ceramic", Part::ceramic, inner, outer, -glue - g.ceramic.thickness, -glue});
  return parts;
}

std::vector<BentFace> bent_section(const Sector& sector, int nodal_diameters, double contact_radius,
                                   const Eigenmode& mode) {
  const auto surface = surface_motion(sector, nodal_diameters, mode);
  const auto contact = at_radius(surface, contact_radius).axial;
  const int through =
      2 * (sector.around / 2);  // the middle of the tooth, or half a brick beside it
  std::vector<BentFace> faces;
  for (const SectorBrick& brick : sector.bricks)
    if (brick.place[1] == through)
      faces.push_back(face_of(sector, nodal_diameters, brick, mode, contact));
  return faces;
}

}  // namespace twum::inline v0_1::solid
