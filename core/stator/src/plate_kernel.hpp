// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plate_mesh.hpp"

#include <array>
#include <numbers>
#include <vector>

/// The energies of a plate at one radius, for doubles or with derivatives. Fields are R, psi_r, psi_t (P2.1); R only
/// for Kirchhoff's plate.
namespace twum::inline v0_1::stator {

/// Part of a linear form: factor times a derivative of a field.
template <typename S>
struct Term {
  std::size_t row;
  std::size_t field;
  std::size_t order;
  S factor;
};

/// Rows: kappa_r, kappa_t, kappa_x, gamma_r, gamma_t (P2.2); Kirchhoff's the first three (P2.5).
template <typename S>
std::vector<Term<S>> strain_terms(PlateTheory theory, int nodal_diameters, const S& radius) {
  const double n = nodal_diameters;
  const S inverse = 1.0 / radius;
  if (theory == PlateTheory::kirchhoff) {
    return {{0, 0, 2, S(-1.0)},
            {1, 0, 1, -inverse},
            {1, 0, 0, n * n * inverse * inverse},
            {2, 0, 1, 2 * n * inverse},
            {2, 0, 0, -2 * n * inverse * inverse}};
  }
  std::vector<Term<S>> terms{{0, 1, 1, S(1.0)}, {1, 1, 0, inverse}, {2, 1, 0, -n * inverse},
                             {3, 0, 1, S(1.0)}, {3, 1, 0, S(1.0)},  {4, 0, 0, -n * inverse}};
  if (nodal_diameters > 0) {
    terms.insert(
        terms.end(),
        {{1, 2, 0, n * inverse}, {2, 2, 1, S(1.0)}, {2, 2, 0, -inverse}, {4, 2, 0, S(1.0)}});
  }
  return terms;
}

/// Rows: R, psi_r, psi_t (P2.4).
template <typename S>
std::vector<Term<S>> motion_terms(PlateTheory theory, int nodal_diameters, const S& radius) {
  if (theory == PlateTheory::kirchhoff) {
    return {{0, 0, 0, S(1.0)}, {1, 0, 1, S(-1.0)}, {2, 0, 0, nodal_diameters / radius}};
  }
  std::vector<Term<S>> terms{{0, 0, 0, S(1.0)}, {1, 1, 0, S(1.0)}};
  if (nodal_diameters > 0) terms.push_back({2, 2, 0, S(1.0)});
  return terms;
}

/// Stress resultants that do work on the strains (P2.3).
template <typename S>
std::array<S, 5> stresses(const SectionOf<S>& section, const std::array<S, 5>& strain) {
  const S& stiffness = section.bending_stiffness;
  const S& nu = section.poisson_ratio;
  return {stiffness * (strain[0] + nu * strain[1]), stiffness * (strain[1] + nu * strain[0]),
          0.5 * (1.0 - nu) * stiffness * strain[2], section.shear_stiffness * strain[3],
          section.shear_stiffness * strain[4]};
}

/// A Gauss point of an element, in numbers of the kind S.
template <typename S>
struct PlatePoint {
  S radius;  ///< [m]
  S half;    ///< half of the element's width [m]
  S weight;  ///< weight of the point in an integral over the plate of cos^2 (n phi) [m^2]
};

template <typename S>
PlatePoint<S> plate_point(const Mesh& mesh, const Element& element,
                          const std::vector<SegmentOf<S>>& segments, std::size_t q) {
  const SegmentOf<S>& segment = segments[element.segment];
  const S width = segment.outer - segment.inner;
  const S half = width * (0.5 * (element.to - element.from));
  const S middle = segment.inner + width * (0.5 * (element.to + element.from));
  const S radius = middle + half * element.table->points[q];
  const double angle = mesh.nodal_diameters == 0 ? 2 * std::numbers::pi : std::numbers::pi;
  return {radius, half, angle * element.table->weights[q] * half * radius};
}

template <typename S>
using Fields = std::array<std::array<S, 3>, 3>;  // [field][order of derivative with respect to rho]

/// Highest derivative of a field in the energies of an element: functions with a continuous value have the first.
inline std::size_t orders(const Element& element) {
  return element.table->basis.continuity == Continuity::value ? 2 : 3;
}

/// Fields of a vector of coefficients, and their derivatives, at a Gauss point. The coefficient of a
/// Hermite function of slope is the slope: the function is scaled by half of the element's width.
/// @tparam C  of the coefficients: double where they do not move
template <typename S, typename C>
Fields<S> fields_at(const Element& element, std::size_t q, const S& half,
                    const std::vector<C>& coefficients) {
  Fields<S> fields;
  for (auto& field : fields) field = {S(0.0), S(0.0), S(0.0)};
  const Basis& basis = element.table->basis;
  S power(1.0);
  for (std::size_t order = 0; order < orders(element); ++order) {
    const auto& shapes = element.table->values[order][q];
    for (std::size_t field = 0; field < element.dofs.size(); ++field) {
      C plain(0.0);
      C slopes(0.0);
      for (std::size_t i = 0; i < shapes.size(); ++i) {
        const int dof = element.dofs[field][i];
        if (dof < 0) continue;
        C& sum = basis.is_slope(static_cast<int>(i)) ? slopes : plain;
        sum += shapes[i] * coefficients[static_cast<std::size_t>(dof)];
      }
      fields[field][order] = (plain + half * slopes) * power;
    }
    power = power / half;
  }
  return fields;
}

/// Rows of linear forms, applied to fields.
template <std::size_t kRows, typename S>
std::array<S, kRows> applied(const std::vector<Term<S>>& terms, const Fields<S>& fields) {
  std::array<S, kRows> rows;
  rows.fill(S(0.0));
  for (const Term<S>& term : terms) rows[term.row] += term.factor * fields[term.field][term.order];
  return rows;
}

/// The transpose: adds the work of rows of forces on the fields.
template <std::size_t kRows, typename S>
void add_transposed(Fields<S>& forces, const std::vector<Term<S>>& terms,
                    const std::array<S, kRows>& rows) {
  for (const Term<S>& term : terms) forces[term.field][term.order] += term.factor * rows[term.row];
}

/// The transpose of fields_at(): adds forces on the fields at a Gauss point to those on the coefficients.
template <typename S>
void add_to_coefficients(std::vector<S>& result, const Element& element, std::size_t q,
                         const S& half, const Fields<S>& forces) {
  const Basis& basis = element.table->basis;
  S power(1.0);
  for (std::size_t order = 0; order < orders(element); ++order) {
    const auto& shapes = element.table->values[order][q];
    for (std::size_t field = 0; field < element.dofs.size(); ++field) {
      const S plain = forces[field][order] * power;
      const S slope = plain * half;
      for (std::size_t i = 0; i < shapes.size(); ++i) {
        const int dof = element.dofs[field][i];
        if (dof < 0) continue;
        result[static_cast<std::size_t>(dof)] +=
            shapes[i] * (basis.is_slope(static_cast<int>(i)) ? slope : plain);
      }
    }
    power = power / half;
  }
}

}  // namespace twum::inline v0_1::stator
