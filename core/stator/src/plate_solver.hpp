// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plate_kernel.hpp"

#include <vector>

namespace twum::inline v0_1::stator {

/// Solutions of K c = lambda M c, smallest eigenvalue first, c' M c = 1 (P3.1).
struct Spectrum {
  std::vector<double> eigenvalues;           ///< omega^2 [1/s^2]
  std::vector<std::vector<double>> vectors;  ///< coefficients of the mesh's functions
};

/// omega^2 of lambda^2 = 1, of the segment where it is smallest [1/s^2]. Modes that bend the plate lie above
/// it, apart from those of very narrow rings; rigid-body modes are zero but for rounding.
double unit_eigenvalue(const std::vector<Segment>& segments);

/// The lowest solutions; fewer than `count` where rounding leaves fewer.
Spectrum solve(const Mesh& mesh, const std::vector<Segment>& segments, int count);

/// A force on a plate that vibrates in a mode c, and the share of c in the answer.
struct ModeLoad {
  std::vector<double> force;  ///< r, with c' r = 0
  double share;               ///< c' M x
};

/// Solutions x of (K - lambda M) x = r with a given c' M x, for each load: K - lambda M alone has no inverse.
std::vector<std::vector<double>> answers_beside_mode(const Mesh& mesh,
                                                     const std::vector<Segment>& segments,
                                                     const std::vector<double>& mode,
                                                     double eigenvalue,
                                                     const std::vector<ModeLoad>& loads);

/// (K - lambda M) c and M c of a plate in numbers of the kind S. With dual numbers and a solution c the
/// derivatives are (dK - lambda dM) c and dM c, which is all that derivatives of modes need.
template <typename S>
struct Forces {
  std::vector<S> residual;
  std::vector<S> inertia;
};

template <typename S>
Forces<S> forces(const Mesh& mesh, const std::vector<SegmentOf<S>>& segments,
                 const std::vector<double>& solution, double eigenvalue) {
  const auto unknowns = static_cast<std::size_t>(mesh.unknowns);
  Forces<S> result{std::vector<S>(unknowns, S(0.0)), std::vector<S>(unknowns, S(0.0))};
  Fields<S> zero;
  for (auto& field : zero) field = {S(0.0), S(0.0), S(0.0)};
  for (const Element& element : mesh.elements) {
    const SectionOf<S>& section = segments[element.segment].section;
    for (std::size_t q = 0; q < element.table->points.size(); ++q) {
      const auto at = plate_point(mesh, element, segments, q);
      const auto fields = fields_at(element, q, at.half, solution);
      const auto strains = strain_terms(mesh.theory, mesh.nodal_diameters, at.radius);
      const auto motions = motion_terms(mesh.theory, mesh.nodal_diameters, at.radius);
      auto stress = stresses(section, applied<5>(strains, fields));
      for (S& s : stress) s *= at.weight;
      const auto motion = applied<3>(motions, fields);
      const std::array<S, 3> momentum{motion[0] * section.mass * at.weight,
                                      motion[1] * section.rotary_inertia * at.weight,
                                      motion[2] * section.rotary_inertia * at.weight};
      Fields<S> elastic = zero;
      Fields<S> inertia = zero;
      add_transposed<5>(elastic, strains, stress);
      add_transposed<3>(inertia, motions, momentum);
      for (std::size_t f = 0; f < 3; ++f) {
        for (std::size_t d = 0; d < 3; ++d) elastic[f][d] -= eigenvalue * inertia[f][d];
      }
      add_to_coefficients(result.residual, element, q, at.half, elastic);
      add_to_coefficients(result.inertia, element, q, at.half, inertia);
    }
  }
  return result;
}

/// c' (K - lambda M) c of a plate in numbers of the kind S. With dual numbers and a solution c the derivatives are those of
/// lambda, by Rayleigh's quotient.
template <typename S>
S energy(const Mesh& mesh, const std::vector<SegmentOf<S>>& segments,
         const std::vector<double>& solution, double eigenvalue) {
  S sum(0.0);
  for (const Element& element : mesh.elements) {
    const SectionOf<S>& section = segments[element.segment].section;
    for (std::size_t q = 0; q < element.table->points.size(); ++q) {
      const auto at = plate_point(mesh, element, segments, q);
      const auto fields = fields_at(element, q, at.half, solution);
      const auto strain =
          applied<5>(strain_terms(mesh.theory, mesh.nodal_diameters, at.radius), fields);
      const auto motion =
          applied<3>(motion_terms(mesh.theory, mesh.nodal_diameters, at.radius), fields);
      const auto stress = stresses(section, strain);
      S density(0.0);
      for (std::size_t i = 0; i < strain.size(); ++i) density += stress[i] * strain[i];
      density -=
          eigenvalue * (section.mass * motion[0] * motion[0] +
                        section.rotary_inertia * (motion[1] * motion[1] + motion[2] * motion[2]));
      sum += at.weight * density;
    }
  }
  return sum;
}

}  // namespace twum::inline v0_1::stator
