// SPDX-License-Identifier: Apache-2.0
#include <twum/solid/deck.hpp>

#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>

namespace twum::inline v0_1::solid {
namespace {

using stator::StatorGeometry;

constexpr std::string_view kNames[kParts] = {"METAL", "CERAMIC", "GLUE"};

struct Elastic {
  double youngs_modulus, poisson_ratio, density;
};

Elastic elastic(const StatorGeometry& g, Part part) {
  switch (part) {
    case Part::metal:
      return {g.substrate.youngs_modulus, g.substrate.poisson_ratio, g.substrate.density};
    case Part::ceramic:
      return {g.ceramic.youngs_modulus, g.ceramic.poisson_ratio, g.ceramic.density};
    case Part::glue: break;
  }
  return {g.glue.youngs_modulus, g.glue.poisson_ratio, g.glue.density};
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.12g", value);
  return text;
}

std::string count(std::size_t value) { return std::to_string(value); }

std::string node_lines(const Sector& sector) {
  std::string text = "*NODE, NSET=ALL\n";
  for (std::size_t i = 0; i < sector.nodes.size(); ++i) {
    const SectorNode& node = sector.nodes[i];
    text += count(i + 1) + "," + number(node.radius * std::cos(node.angle)) + "," +
            number(node.radius * std::sin(node.angle)) + "," + number(node.height) + "\n";
  }
  return text;
}

std::string brick_line(const SectorBrick& brick, std::size_t number) {
  std::string text = count(number);
  for (std::size_t n = 0; n < brick.nodes.size(); ++n)  // 16 entries a line
    text += (n == 10 ? ",\n" : ",") + std::to_string(brick.nodes[n] + 1);
  return text + "\n";
}

std::string part_lines(const Sector& sector, const StatorGeometry& geometry, Part part) {
  const std::string name(kNames[static_cast<std::size_t>(part)]);
  std::string bricks;
  for (std::size_t b = 0; b < sector.bricks.size(); ++b)
    if (sector.bricks[b].part == part) bricks += brick_line(sector.bricks[b], b + 1);
  if (bricks.empty()) return bricks;
  const Elastic solid = elastic(geometry, part);
  return "*ELEMENT, TYPE=C3D20R, ELSET=" + name + "\n" + bricks + "*MATERIAL, NAME=" + name +
         "\n*ELASTIC\n" + number(solid.youngs_modulus) + "," + number(solid.poisson_ratio) +
         "\n*DENSITY\n" + number(solid.density) + "\n*SOLID SECTION, ELSET=" + name +
         ", MATERIAL=" + name + "\n";
}

// The faces of one side of the sector. Face 3 of a brick is that of its first places, face 5 that of its last ones.
std::string side_lines(const Sector& sector, const char* name, int row, const char* face) {
  std::string text = "*SURFACE, NAME=" + std::string(name) + "\n";
  for (std::size_t b = 0; b < sector.bricks.size(); ++b)
    if (sector.bricks[b].place[1] == row) text += count(b + 1) + "," + face + "\n";
  return text;
}

// The motion of the first side is that of the last one, turned (F1.1).
std::string symmetry_lines(const Sector& sector) {
  return side_lines(sector, "FIRST", 0, "S3") +
         side_lines(sector, "LAST", 2 * (sector.around - 1), "S5") +
         "*TIE, NAME=SIDES, CYCLIC SYMMETRY, POSITION TOLERANCE=1e-7\nFIRST,LAST\n"
         "*CYCLIC SYMMETRY MODEL, N=" +
         std::to_string(sector.count) + ", NGRAPH=1, TIE=SIDES\n0.,0.,0.,0.,0.,1.\n";
}

// Nodes of the first side follow those of the last one, which are held.
std::string support_lines(const Sector& sector, stator::InnerEdge support) {
  std::string held, local;
  for (std::size_t i = 0; i < sector.nodes.size(); ++i) {
    const Place& place = sector.nodes[i].place;
    if (place[0] != 0 || place[1] == 0) continue;
    held += count(i + 1) + (support == stator::InnerEdge::clamped ? ",1,3\n" : ",2,3\n");
    local += count(i + 1) + "\n";
  }
  switch (support) {
    case stator::InnerEdge::free: return "";
    case stator::InnerEdge::clamped: return "*BOUNDARY\n" + held;
    case stator::InnerEdge::supported: break;
  }
  // Directions 1, 2 and 3 of these nodes are along radius, circumference and axis.
  return "*NSET, NSET=EDGE\n" + local + "*TRANSFORM, NSET=EDGE, TYPE=C\n0.,0.,0.,0.,0.,1.\n" +
         "*BOUNDARY\n" + held;
}

}  // namespace

std::string deck_text(const Sector& sector, const StatorGeometry& geometry, int nodal_diameters,
                      int modes) {
  const std::string n = std::to_string(nodal_diameters);
  std::string text = node_lines(sector);
  for (int part = 0; part < kParts; ++part)
    text += part_lines(sector, geometry, static_cast<Part>(part));
  return text + symmetry_lines(sector) + support_lines(sector, geometry.support) +
         "*STEP\n*FREQUENCY\n" + std::to_string(modes) +
         "\n*SELECT CYCLIC SYMMETRY MODES, NMIN=" + n + ", NMAX=" + n +
         "\n*NODE PRINT, NSET=ALL, GLOBAL=YES\nU\n*NODE FILE, GLOBAL=YES\nU\n*END STEP\n";
}

}  // namespace twum::inline v0_1::solid
