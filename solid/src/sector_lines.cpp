// SPDX-License-Identifier: Apache-2.0
#include "sector_lines.hpp"

#include <twum/stator/laminate.hpp>

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::solid {
namespace {

using stator::StatorGeometry;

// Lines closer than this share of the outer radius are one line.
constexpr double kSameLine = 1e-9;

bool within(double x, double low, double high) { return x > low && x < high; }

// In rising order, each once.
std::vector<double> distinct(std::vector<double> lines, double tolerance) {
  std::sort(lines.begin(), lines.end());
  const auto same = [=](double a, double b) { return b - a <= tolerance; };
  lines.erase(std::unique(lines.begin(), lines.end(), same), lines.end());
  return lines;
}

// Each interval in equal parts of about the size wanted.
std::vector<double> divided(const std::vector<double>& lines, double size) {
  std::vector<double> all{lines.front()};
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    const double length = lines[i + 1] - lines[i];
    const int parts = std::max(1, static_cast<int>(std::lround(length / size)));
    for (int k = 1; k < parts; ++k) all.push_back(lines[i] + length * k / parts);
    all.push_back(lines[i + 1]);
  }
  return all;
}

// z_n of the layers without teeth, above the bottom of the metal (P1.1).
double neutral_plane(const StatorGeometry& g, double radius) {
  std::vector<stator::Layer> layers;
  double bottom = 0;
  if (within(radius, g.ceramic.inner_radius, g.ceramic.outer_radius)) {
    const auto& [t, e, nu, rho] = g.glue;
    layers = {
        {g.ceramic.thickness, g.ceramic.youngs_modulus, g.ceramic.poisson_ratio, g.ceramic.density},
        {t, e, nu, rho}};
    bottom = -g.ceramic.thickness - t;
  }
  layers.push_back({g.substrate.thickness, g.substrate.youngs_modulus, g.substrate.poisson_ratio,
                    g.substrate.density});
  return bottom + stator::section_of(layers).neutral_plane;
}

}  // namespace

double inner_radius(const StatorGeometry& g) {
  return g.web ? std::min(g.web->inner_radius, g.substrate.inner_radius) : g.substrate.inner_radius;
}

bool has_slots(const StatorGeometry& g) { return g.teeth && g.teeth->slot_width > 0; }

double web_bottom_of(const StatorGeometry& g, double contact_radius) {
  if (!g.web || g.ceramic.inner_radius < g.web->outer_radius) return 0;
  const double wanted = neutral_plane(g, contact_radius) - 0.5 * g.web->thickness;
  return std::clamp(wanted, 0.0, std::max(0.0, g.substrate.thickness - g.web->thickness));
}

std::vector<SolidLayer> solid_layers(const StatorGeometry& g, double web_bottom, double radius) {
  std::vector<SolidLayer> layers;
  if (within(radius, g.ceramic.inner_radius, g.ceramic.outer_radius)) {
    const double top = -g.glue.thickness;
    layers.push_back({top - g.ceramic.thickness, top, Part::ceramic, false});
    if (g.glue.thickness > 0) layers.push_back({top, 0, Part::glue, false});
  }
  const bool in_web = g.web && within(radius, g.web->inner_radius, g.web->outer_radius);
  const double bottom = in_web ? web_bottom : 0;
  const double top = bottom + (in_web ? g.web->thickness : g.substrate.thickness);
  layers.push_back({bottom, top, Part::metal, false});
  if (g.teeth && within(radius, g.teeth->inner_radius, g.teeth->outer_radius))
    layers.push_back({top, top + g.teeth->height, Part::metal, has_slots(g)});
  return layers;
}

std::vector<double> radial_lines(const StatorGeometry& g, double contact_radius, double size) {
  const double inner = inner_radius(g), outer = g.substrate.outer_radius;
  std::vector<double> lines{inner,
                            outer,
                            contact_radius,
                            g.ceramic.inner_radius,
                            g.ceramic.outer_radius,
                            g.electrodes.inner_radius.value_or(g.ceramic.inner_radius),
                            g.electrodes.outer_radius.value_or(g.ceramic.outer_radius)};
  if (g.web) lines.insert(lines.end(), {g.web->inner_radius, g.web->outer_radius});
  if (g.teeth) lines.insert(lines.end(), {g.teeth->inner_radius, g.teeth->outer_radius});
  return divided(distinct(lines, kSameLine * outer), size);
}

std::vector<double> axial_lines(const StatorGeometry& g, double web_bottom,
                                const std::vector<double>& radii, double size) {
  std::vector<double> lines;
  for (std::size_t i = 0; i + 1 < radii.size(); ++i)
    for (const SolidLayer& layer : solid_layers(g, web_bottom, 0.5 * (radii[i] + radii[i + 1])))
      lines.insert(lines.end(), {layer.bottom, layer.top});
  return divided(distinct(lines, kSameLine * g.substrate.outer_radius), size);
}

}  // namespace twum::inline v0_1::solid
