// SPDX-License-Identifier: Apache-2.0
#include "surface.hpp"

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::solid {
namespace {

// Indices of the nodes on the top of each line of constant radius, in the order of their angles.
std::vector<std::vector<std::size_t>> tops(const Sector& sector) {
  std::vector<std::vector<std::size_t>> lines(sector.radii.size());
  const auto line_of = [&](std::size_t node) -> std::vector<std::size_t>& {
    return lines[static_cast<std::size_t>(sector.nodes[node].place[0] / 2)];
  };
  for (std::size_t i = 0; i < sector.nodes.size(); ++i) {
    const Place& place = sector.nodes[i].place;
    if (place[0] % 2 != 0) continue;
    auto& line = line_of(i);
    const int highest = line.empty() ? place[2] : sector.nodes[line.front()].place[2];
    if (place[2] > highest) line.clear();
    if (place[2] >= highest) line.push_back(i);
  }
  for (auto& line : lines)
    std::sort(line.begin(), line.end(), [&](std::size_t a, std::size_t b) {
      return sector.nodes[a].place[1] < sector.nodes[b].place[1];
    });
  return lines;
}

// Simpson's rule: each brick has a node at either end and one in its middle.
SurfaceMotion mean_along(const Sector& sector, int n, const Eigenmode& mode,
                         const std::vector<std::size_t>& line) {
  SurfaceMotion sum{sector.nodes[line.front()].radius, {}, {}, {}};
  const auto angle = [&](std::size_t i) { return sector.nodes[line[i]].angle; };
  const double whole = angle(line.size() - 1) - angle(0);
  for (std::size_t i = 0; i + 2 < line.size(); i += 2) {
    const double share = (angle(i + 2) - angle(i)) / (6 * whole);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto weight = std::polar(k == 1 ? 4 * share : share, -n * angle(i + k));
      const auto& u = mode.motion[line[i + k]];
      sum.radial += weight * u[0], sum.tangential += weight * u[1], sum.axial += weight * u[2];
    }
  }
  return sum;
}

}  // namespace

std::vector<SurfaceMotion> surface_motion(const Sector& sector, int nodal_diameters,
                                          const Eigenmode& mode) {
  std::vector<SurfaceMotion> motion;
  for (const auto& line : tops(sector))
    motion.push_back(mean_along(sector, nodal_diameters, mode, line));
  return motion;
}

const SurfaceMotion& at_radius(const std::vector<SurfaceMotion>& surface, double radius) {
  return *std::min_element(surface.begin(), surface.end(),
                           [=](const SurfaceMotion& a, const SurfaceMotion& b) {
                             return std::abs(a.radius - radius) < std::abs(b.radius - radius);
                           });
}

}  // namespace twum::inline v0_1::solid
