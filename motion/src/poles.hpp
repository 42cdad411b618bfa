// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <complex>
#include <vector>

namespace twum::inline v0_1::motion {

/// A matrix of rates in units of its states' sizes: in SI these differ by so much that rounding would reach the poles.
template <typename Matrix, typename Sizes>
auto in_sizes(const Matrix& rates, const Sizes& sizes) {
  return (sizes.cwiseInverse().asDiagonal() * rates * sizes.asDiagonal()).eval();
}

/// Eigenvalues of a matrix of rates [1/s].
template <typename Matrix, typename Sizes>
std::vector<Complex> poles_of(const Matrix& rates, const Sizes& sizes) {
  const auto scaled = in_sizes(rates, sizes);
  const auto values =
      Eigen::EigenSolver<std::decay_t<decltype(scaled)>>(scaled, false).eigenvalues().eval();
  return {values.begin(), values.end()};
}

/// The pole next to a place.
inline Complex nearest_pole(const std::vector<Complex>& poles, Complex place) {
  return *std::ranges::min_element(poles, {}, [&](Complex p) { return std::abs(p - place); });
}

}  // namespace twum::inline v0_1::motion
