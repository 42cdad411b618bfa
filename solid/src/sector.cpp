// SPDX-License-Identifier: Apache-2.0
#include <twum/solid/sector.hpp>

#include "sector_lines.hpp"

#include <twum/base/error.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

namespace twum::inline v0_1::solid {
namespace {

using stator::StatorGeometry;

constexpr double kTurn = 2 * std::numbers::pi;
// CalculiX needs about 100 kB for each brick of a sector, and minutes for this many.
constexpr double kMostBricks = 20000;

// What the mesh is made of, before there are nodes.
struct Grid {
  const StatorGeometry& geometry;
  double web_bottom;
  double pitch;
  int tooth_bricks;  // 0 without slots
  int around;
  std::vector<double> radii;
  std::vector<double> heights;
};

// Lines at constant angle from one side of the sector to the other: half a slot, the tooth, half a slot. The slot's walls are
// parallel; inside the teeth, where there are no slots, the lines keep their angles.
std::vector<double> angular_lines(const Grid& grid, double radius) {
  std::vector<double> lines{-grid.pitch / 2};
  const bool slots = grid.tooth_bricks > 0;
  const double slot =
      slots ? grid.geometry.teeth->slot_width / std::max(radius, grid.geometry.teeth->inner_radius)
            : 0;
  const int parts = slots ? grid.tooth_bricks : grid.around;
  for (int j = slots ? 0 : 1; j <= parts; ++j)
    lines.push_back((grid.pitch - slot) * (static_cast<double>(j) / parts - 0.5));
  if (slots) lines.push_back(grid.pitch / 2);
  return lines;
}

// A line, or the middle between two.
double between(const std::vector<double>& lines, int half) {
  const auto line = static_cast<std::size_t>(half / 2);
  return half % 2 == 0 ? lines[line] : 0.5 * (lines[line] + lines[line + 1]);
}

SectorNode node_at(const Grid& grid, const Place& place) {
  const double radius = between(grid.radii, place[0]);
  return {place, radius, between(angular_lines(grid, radius), place[1]),
          between(grid.heights, place[2])};
}

// Adds bricks, and the nodes that they share once.
class Builder {
 public:
  explicit Builder(Sector& sector) : sector_(sector) {}

  void add(const Grid& grid, const Place& place, Part part) {
    SectorBrick brick{place, {}, part};
    for (std::size_t n = 0; n < brick.nodes.size(); ++n) {
      Place at = place;
      for (std::size_t d = 0; d < 3; ++d) at[d] += brick_places()[n][d];
      const auto [found, added] = known_.try_emplace(at, static_cast<int>(sector_.nodes.size()));
      if (added) sector_.nodes.push_back(node_at(grid, at));
      brick.nodes[n] = found->second;
    }
    sector_.bricks.push_back(brick);
  }

 private:
  Sector& sector_;
  std::map<Place, int> known_;
};

// The bricks between two radii.
void add_column(Builder& builder, const Grid& grid, int i) {
  const auto line = static_cast<std::size_t>(i);
  const double radius = 0.5 * (grid.radii[line] + grid.radii[line + 1]);
  for (const SolidLayer& layer : solid_layers(grid.geometry, grid.web_bottom, radius)) {
    for (int k = 0; k + 1 < static_cast<int>(grid.heights.size()); ++k) {
      const double height = between(grid.heights, 2 * k + 1);
      if (height < layer.bottom || height > layer.top) continue;
      for (int j = 0; j < grid.around; ++j) {
        const bool in_slot = layer.toothed && (j == 0 || j + 1 == grid.around);
        if (!in_slot) builder.add(grid, {2 * i, 2 * j, 2 * k}, layer.part);
      }
    }
  }
}

void check_sector(const StatorGeometry& g, int wavelengths, double contact_radius, int elements) {
  stator::check_geometry(g);
  if (elements < 1 || elements > kMostElements)
    throw InputError("elements through the plate must be 1 to " + std::to_string(kMostElements) +
                     ", but are " + std::to_string(elements));
  if (!(contact_radius > inner_radius(g) && contact_radius <= g.substrate.outer_radius))
    throw InputError("contact_radius must be on the plate, but is not");
  if (has_slots(g) && g.teeth->count <= 2 * wavelengths)
    throw InputError("teeth_count must be more than two for each wavelength, " +
                     std::to_string(2 * wavelengths) + ", but is " +
                     std::to_string(g.teeth->count));
}

void check_size(const Grid& grid) {
  const double bricks = static_cast<double>(grid.radii.size()) *
                        static_cast<double>(grid.heights.size()) * grid.around;
  if (bricks > kMostBricks)
    throw InputError("a sector of this stator would take more than " +
                     std::to_string(static_cast<int>(kMostBricks)) +
                     " bricks; use fewer elements through the plate");
}

// Sectors of a stator without slots: about as wide as a brick is long, and enough for n + 2 nodal diameters.
int sector_count(const StatorGeometry& g, int wavelengths, double size) {
  if (has_slots(g)) return g.teeth->count;
  const double by_size = kTurn * g.substrate.outer_radius / size;
  return std::max(4 * (wavelengths + 2), static_cast<int>(std::lround(by_size)));
}

}  // namespace

double Sector::pitch() const { return kTurn / count; }

const std::array<Place, 20>& brick_places() {
  static constexpr std::array<Place, 20> kPlaces{
      {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2},
       {0, 2, 2}, {1, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 1, 0}, {1, 0, 2}, {2, 1, 2},
       {1, 2, 2}, {0, 1, 2}, {0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}}};
  return kPlaces;
}

int most_nodal_diameters(const Sector& sector) { return (sector.count - 1) / 2; }

Sector make_sector(const StatorGeometry& g, int wavelengths, double contact_radius, int elements) {
  check_sector(g, wavelengths, contact_radius, elements);
  const double size = g.substrate.thickness / elements;
  const auto radii = radial_lines(g, contact_radius, size);
  Sector sector;
  sector.count = sector_count(g, wavelengths, size);
  sector.radii = radii;
  int tooth_bricks = 0;
  if (has_slots(g)) {
    const double tooth = sector.pitch() * contact_radius - g.teeth->slot_width;
    tooth_bricks = std::max(1, static_cast<int>(std::lround(tooth / size)));
  }
  sector.around = tooth_bricks > 0 ? tooth_bricks + 2 : 1;
  const double web_bottom = web_bottom_of(g, contact_radius);
  const Grid grid{g,
                  web_bottom,
                  sector.pitch(),
                  tooth_bricks,
                  sector.around,
                  radii,
                  axial_lines(g, web_bottom, radii, size)};
  check_size(grid);
  Builder builder(sector);
  for (int i = 0; i + 1 < static_cast<int>(radii.size()); ++i) add_column(builder, grid, i);
  return sector;
}

}  // namespace twum::inline v0_1::solid
