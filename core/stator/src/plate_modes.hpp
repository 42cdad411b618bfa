// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plate_mesh.hpp"

#include <vector>

namespace twum::inline v0_1::stator {

/// R of a vector of coefficients on one element, as coefficients of Legendre polynomials.
/// @param half  of the element's width [m]
template <typename S>
std::vector<S> legendre_series(const Element& element, std::size_t field, const S& half,
                               const std::vector<S>& coefficients) {
  const Basis& basis = element.table->basis;
  std::vector<S> series;
  for (std::size_t i = 0; i < element.dofs[field].size(); ++i) {
    const auto& function = basis.legendre[i];
    if (series.size() < function.size()) series.resize(function.size(), S(0.0));
    const int dof = element.dofs[field][i];
    if (dof < 0) continue;
    S coefficient = coefficients[static_cast<std::size_t>(dof)];
    if (basis.is_slope(static_cast<int>(i))) coefficient = coefficient * half;
    for (std::size_t k = 0; k < function.size(); ++k) series[k] += function[k] * coefficient;
  }
  return series;
}

/// R of a solution.
RadialFunction deflection(const Mesh& mesh, const std::vector<Segment>& segments,
                          const std::vector<double>& coefficients);

/// omega^2 as a frequency [Hz]: 0 for a rigid-body mode, which rounding leaves an eigenvalue of at most 1e-6
/// of unit_eigenvalue().
double frequency_of(double eigenvalue, const std::vector<Segment>& segments);

}  // namespace twum::inline v0_1::stator
