// SPDX-License-Identifier: Apache-2.0
#include "mode_derivatives.hpp"

namespace twum::stator {
namespace {

using Vector = std::vector<double>;

double product(const Vector& a, const Vector& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

// Derivatives of a vector of dual numbers in one direction.
Vector direction(const std::vector<Derived>& numbers, std::size_t k) {
  Vector result;
  for (const Derived& number : numbers) result.push_back(number.d[k]);
  return result;
}

}  // namespace

Derived derived_eigenvalue(const Mesh& mesh, const std::vector<SegmentOf<Derived>>& segments,
                           const Spectrum& spectrum, std::size_t mode) {
  const Vector& c = spectrum.vectors[mode];
  const auto change = forces(mesh, segments, c, spectrum.eigenvalues[mode]);
  Derived eigenvalue(spectrum.eigenvalues[mode]);
  for (std::size_t k = 0; k < kDimensions; ++k) {
    eigenvalue.d[k] = product(c, direction(change.residual, k));
  }
  return eigenvalue;
}

Solution<Derived> derived_solution(const Mesh& mesh,
                                   const std::vector<SegmentOf<Derived>>& segments,
                                   const Spectrum& spectrum, std::size_t mode) {
  const Vector& c = spectrum.vectors[mode];
  const double lambda = spectrum.eigenvalues[mode];
  const auto change = forces(mesh, segments, c, lambda);
  Solution<Derived> solution{Derived(lambda), {c.begin(), c.end()}};
  for (std::size_t k = 0; k < kDimensions; ++k) {
    const Vector residual = direction(change.residual, k);
    solution.eigenvalue.d[k] = product(c, residual);
    for (std::size_t j = 0; j < spectrum.vectors.size(); ++j) {
      const Vector& other = spectrum.vectors[j];
      const double share = j == mode
                               ? -0.5 * product(c, direction(change.inertia, k))
                               : product(other, residual) / (lambda - spectrum.eigenvalues[j]);
      for (std::size_t i = 0; i < c.size(); ++i) solution.coefficients[i].d[k] += share * other[i];
    }
  }
  return solution;
}

}  // namespace twum::stator
