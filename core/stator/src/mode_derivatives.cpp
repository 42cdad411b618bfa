// SPDX-License-Identifier: Apache-2.0
#include "mode_derivatives.hpp"

namespace twum::inline v0_1::stator {
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
  Derived eigenvalue = energy(mesh, segments, spectrum.vectors[mode], spectrum.eigenvalues[mode]);
  eigenvalue.v = spectrum.eigenvalues[mode];
  return eigenvalue;
}

// (K - lambda M) dc = (dlambda M - dK + lambda dM) c, with c' M dc = -c' dM c / 2 from c' M c = 1.
Solution<Derived> derived_solution(const Mesh& mesh, const std::vector<Segment>& segments,
                                   const std::vector<SegmentOf<Derived>>& dual_segments,
                                   const Spectrum& spectrum, std::size_t mode) {
  const Vector& c = spectrum.vectors[mode];
  const double lambda = spectrum.eigenvalues[mode];
  const auto change = forces(mesh, dual_segments, c, lambda);
  Solution<Derived> solution{Derived(lambda), {c.begin(), c.end()}};
  std::vector<ModeLoad> loads(kDimensions);
  for (std::size_t k = 0; k < kDimensions; ++k) {
    ModeLoad& load = loads[k];
    load = {direction(change.residual, k), -0.5 * product(c, direction(change.inertia, k))};
    const double slope = solution.eigenvalue.d[k] = product(c, load.force);
    for (std::size_t i = 0; i < c.size(); ++i)
      load.force[i] = slope * change.inertia[i].v - load.force[i];
  }
  const auto motions = answers_beside_mode(mesh, segments, c, lambda, loads);
  for (std::size_t k = 0; k < kDimensions; ++k)
    for (std::size_t i = 0; i < c.size(); ++i) solution.coefficients[i].d[k] = motions[k][i];
  return solution;
}

}  // namespace twum::inline v0_1::stator
