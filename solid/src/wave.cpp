// SPDX-License-Identifier: Apache-2.0
#include <twum/solid/wave.hpp>

#include "force_factor.hpp"
#include "surface.hpp"

#include <twum/base/error.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace twum::inline v0_1::solid {
namespace {

using stator::StatorGeometry;

// Axial motion below this share of the largest has no sign: CalculiX prints seven digits.
constexpr double kNoSign = 1e-5;

// Sign changes from a radius outwards. The phase of a mode is free, so the largest motion is made real.
int sign_changes(const std::vector<SurfaceMotion>& surface, double inner) {
  const auto largest =
      std::max_element(surface.begin(), surface.end(), [](const auto& a, const auto& b) {
        return std::abs(a.axial) < std::abs(b.axial);
      })->axial;
  int changes = 0;
  double before = 0;
  for (const SurfaceMotion& at : surface) {
    const double here = (at.axial / largest).real();
    if (at.radius < inner || !(std::abs(here) > kNoSign)) continue;
    if (before * here < 0) ++changes;
    before = here;
  }
  return changes;
}

// F2.2. A sector of a wave that travels has 1 kg; of a standing wave, half of that in the mean over all sectors. Without nodal
// diameters all sectors move alike.
double modal_mass(const Sector& sector, int n, const SurfaceMotion& contact) {
  return (n == 0 ? 1 : 0.5) * sector.count / std::norm(contact.axial);
}

double axial_share(const Eigenmode& mode) {
  double axial = 0, all = 0;
  for (const auto& u : mode.motion) {
    axial += std::norm(u[2]);
    all += std::norm(u[0]) + std::norm(u[1]) + std::norm(u[2]);
  }
  return axial / all;
}

// F2.4: in each phase the strains of the sector's ceramic, in step with the wave, count on N_w wavelengths of half waves that
// alternate, 4 N_w / n of the circumference's pi.
double force_factor(const Sector& sector, const StatorGeometry& g, int n, const Eigenmode& mode,
                    const SurfaceMotion& contact) {
  const auto& c = g.ceramic;
  const double e = c.d31 * c.youngs_modulus / (1 - c.poisson_ratio);
  const auto stretch =
      ceramic_stretch(sector, n, mode, g.electrodes.inner_radius.value_or(c.inner_radius),
                      g.electrodes.outer_radius.value_or(c.outer_radius));
  return 4 * g.electrodes.waves_per_phase / n * std::abs(e) / c.thickness *
         std::abs(stretch / contact.axial) / sector.pitch();
}

SolidWave wave_of(const Sector& sector, const StatorGeometry& geometry, int n,
                  double contact_radius, const std::vector<Eigenmode>& modes, std::size_t mode) {
  const auto surface = surface_motion(sector, n, modes[mode]);
  const SurfaceMotion& contact = at_radius(surface, contact_radius);
  const double tangential = std::abs(contact.tangential / contact.axial);
  SolidWave wave{mode,
                 modes[mode].frequency,
                 modal_mass(sector, n, contact),
                 tangential,
                 -(contact.radial / contact.axial).real() / tangential,
                 force_factor(sector, geometry, n, modes[mode], contact),
                 {}};
  for (const SurfaceMotion& at : surface)
    wave.shape.emplace_back(at.radius, (at.axial / contact.axial).real());
  return wave;
}

}  // namespace

SolidMode described(const Sector& sector, int nodal_diameters, double contact_radius,
                    const Eigenmode& mode) {
  const auto surface = surface_motion(sector, nodal_diameters, mode);
  return {nodal_diameters, sign_changes(surface, 0), mode.frequency,
          modal_mass(sector, nodal_diameters, at_radius(surface, contact_radius)),
          axial_share(mode)};
}

SolidWave solid_wave(const Sector& sector, const StatorGeometry& geometry, int wavelengths,
                     double contact_radius, const std::vector<Eigenmode>& modes) {
  const double ring = geometry.web ? geometry.web->outer_radius : 0;
  double least = std::numeric_limits<double>::infinity();
  std::size_t chosen = modes.size();
  for (std::size_t i = 0; i < modes.size(); ++i) {
    if (modes[i].frequency == 0) continue;
    const auto surface = surface_motion(sector, wavelengths, modes[i]);
    const double mass = modal_mass(sector, wavelengths, at_radius(surface, contact_radius));
    if (sign_changes(surface, ring) == 0 && mass < least) least = mass, chosen = i;
  }
  if (chosen == modes.size())
    throw EvaluationError("no-ring-mode", "no mode carries the travelling wave: each of the " +
                                              std::to_string(modes.size()) +
                                              " lowest of the solid changes its sign on the ring");
  return wave_of(sector, geometry, wavelengths, contact_radius, modes, chosen);
}

}  // namespace twum::inline v0_1::solid
