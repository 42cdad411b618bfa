// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mode_derivatives.hpp"
#include "plate_modes.hpp"
#include "stator_plate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

/// Numbers of the drive from a solution, as doubles or with derivatives.
namespace twum::inline v0_1::stator {

/// R and psi_t at a radius.
template <typename S>
struct Motion {
  S deflection;
  S rotation;
};

template <typename S>
Motion<S> motion_at(const Mesh& mesh, const StatorPlate<S>& plate,
                    const std::vector<S>& coefficients, const S& radius) {
  const std::size_t segment = segment_at(plate, value_of(radius));
  const S width = plate.segments[segment].outer - plate.segments[segment].inner;
  const double share =
      (value_of(radius) - value_of(plate.segments[segment].inner)) / value_of(width);
  const auto inside = [&](const Element& element) {
    return element.segment == segment && share <= element.to;
  };
  const Element& element = *std::find_if(mesh.elements.begin(), mesh.elements.end() - 1, inside);
  const S half = width * (0.5 * (element.to - element.from));
  const S middle = plate.segments[segment].inner + width * (0.5 * (element.to + element.from));
  const S x = (radius - middle) / half;
  const S deflection = legendre_sum(legendre_series(element, 0, half, coefficients), x);
  if (mesh.theory == PlateTheory::mindlin) {
    return {deflection, legendre_sum(legendre_series(element, 2, half, coefficients), x)};
  }
  return {deflection, mesh.nodal_diameters * deflection / radius};
}

template <typename S>
S magnitude(const S& x) {
  return value_of(x) < 0 ? -x : x;
}

/// Integral of z_p (kappa_r + kappa_t) rho drho over the electrode [m^2].
template <typename S>
S curvature_under_electrode(const Mesh& mesh, const StatorPlate<S>& plate,
                            const std::vector<S>& coefficients) {
  S integral(0.0);
  for (const Element& element : mesh.elements) {
    if (!plate.electrodes[element.segment]) continue;
    for (std::size_t q = 0; q < element.table->points.size(); ++q) {
      const auto at = plate_point(mesh, element, plate.segments, q);
      const auto strain = applied<5>(strain_terms(mesh.theory, mesh.nodal_diameters, at.radius),
                                     fields_at(element, q, at.half, coefficients));
      integral += plate.levers[element.segment] * (strain[0] + strain[1]) * at.weight;
    }
  }
  return integral / std::numbers::pi;  // weights are those of cos^2 (n phi)
}

/// Largest normal stress of the ceramic at the crest of the wave, over the Gauss points [Pa] (P4.8).
template <typename S>
S largest_stress(const Mesh& mesh, const StatorPlate<S>& plate, const Numbers<S>& x,
                 const std::vector<S>& coefficients) {
  const S& nu = x[Dimension::ceramic_poisson_ratio];
  const S modulus = x[Dimension::ceramic_youngs_modulus] / (1.0 - nu * nu);
  S most(0.0);
  for (const Element& element : mesh.elements) {
    const S& face = plate.faces[element.segment];
    if (value_of(face) == 0) continue;
    for (std::size_t q = 0; q < element.table->points.size(); ++q) {
      const auto at = plate_point(mesh, element, plate.segments, q);
      const auto strain = applied<5>(strain_terms(mesh.theory, mesh.nodal_diameters, at.radius),
                                     fields_at(element, q, at.half, coefficients));
      for (const S& stress : {S(modulus * face * (strain[0] + nu * strain[1])),
                              S(modulus * face * (strain[1] + nu * strain[0]))}) {
        if (std::abs(value_of(stress)) > value_of(most)) most = magnitude(stress);
      }
    }
  }
  return most;
}

template <typename S>
S blocked_capacitance(const Numbers<S>& x, double share_of_area) {  // P4.5
  using enum Dimension;
  const S blocked = x[ceramic_permittivity] - 2.0 * x[ceramic_d31] * x[ceramic_d31] *
                                                  x[ceramic_youngs_modulus] /
                                                  (1.0 - x[ceramic_poisson_ratio]);
  const S& inner = x[electrodes_inner_radius];
  const S& outer = x[electrodes_outer_radius];
  return blocked * std::numbers::pi * (outer * outer - inner * inner) * share_of_area /
         x[ceramic_thickness];
}

/// All numbers of the travelling wave's mode except the mode separation.
template <typename S>
struct ModeNumbers {
  S frequency, modal_mass, modal_stiffness, neutral_plane_distance, tangential_share, force_factor,
      blocked_capacitance, coupling_factor, ceramic_stress;
  std::vector<S> shape_values;
};

/// Of all segments (P4.9) [kg].
template <typename S>
S mass_of(const StatorPlate<S>& plate) {
  S mass(0.0);
  for (const SegmentOf<S>& segment : plate.segments)
    mass += std::numbers::pi * (segment.outer * segment.outer - segment.inner * segment.inner) *
            segment.section.mass;
  return mass;
}

template <typename S>
ModeNumbers<S> mode_numbers(const Mesh& mesh, const StatorPlate<S>& plate, const Numbers<S>& x,
                            const Solution<S>& solution, double waves_per_phase,
                            std::span<const double> offsets) {
  using std::sqrt;
  using enum Dimension;
  const double n = mesh.nodal_diameters;
  const S& radius = x[contact_radius];
  const auto contact = motion_at(mesh, plate, solution.coefficients, radius);
  const S mass = 1.0 / (contact.deflection * contact.deflection);  // P4.1
  const S stiffness = solution.eigenvalue * mass;                  // P4.2
  const std::size_t segment = segment_at(plate, value_of(radius));
  const SectionOf<S>& section = plate.segments[segment].section;
  const S height = section.top - section.neutral_plane;
  const S teeth = plate.tooth_heights[segment];
  const S turn = radius * contact.rotation / (n * contact.deflection);  // 1 without shear
  const S stress = x[ceramic_d31] * x[ceramic_youngs_modulus] / (1.0 - x[ceramic_poisson_ratio]);
  const S curvature =
      curvature_under_electrode(mesh, plate, solution.coefficients) / contact.deflection;
  const S factor = magnitude(stress * curvature * (4 * waves_per_phase / n));  // P4.4
  const S blocked = blocked_capacitance(x, waves_per_phase / n);
  const S motional = factor * factor / stiffness;
  std::vector<S> shape;
  for (const double offset : offsets) {
    shape.push_back(motion_at(mesh, plate, solution.coefficients, S(radius + offset)).deflection /
                    contact.deflection);
  }
  return {sqrt(solution.eigenvalue) / (2 * std::numbers::pi),
          mass,
          stiffness,
          height,
          ((height - teeth) * turn + teeth) / height,  // P4.3
          factor,
          blocked,
          sqrt(motional / (blocked + motional)),  // P4.6
          magnitude(largest_stress(mesh, plate, x, solution.coefficients) / contact.deflection),
          std::move(shape)};
}

}  // namespace twum::inline v0_1::stator
