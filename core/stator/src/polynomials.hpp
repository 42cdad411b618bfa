// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

namespace twum::inline v0_1::stator {

/// Sum of coefficients times Legendre polynomials P_0, P_1, ... at x.
template <typename C, typename S>
S legendre_sum(const std::vector<C>& coefficients, const S& x) {
  S sum(0.0);
  S previous(0.0);
  S current(1.0);
  for (std::size_t k = 0; k < coefficients.size(); ++k) {
    sum += coefficients[k] * current;
    const auto order = static_cast<double>(k);
    const S next = ((2 * order + 1) * x * current - order * previous) / (order + 1);
    previous = current;
    current = next;
  }
  return sum;
}

/// Continuity between neighbouring elements.
enum class Continuity {
  value,  ///< C0
  slope,  ///< C1: value and first derivative
};

/// Shape functions of an element on [-1, 1], each as coefficients of Legendre polynomials: those of the
/// inner end, those of the outer end (one each for C0, value and slope for C1), then bubbles, which vanish
/// at both ends (P3.2, P3.3).
struct Basis {
  Continuity continuity;                      ///< of neighbours
  std::vector<std::vector<double>> legendre;  ///< of each function

  int size() const { return static_cast<int>(legendre.size()); }
  int at_end() const { return continuity == Continuity::value ? 1 : 2; }  ///< functions of one end
  bool is_slope(int function) const { return at_end() == 2 && (function == 1 || function == 3); }
};

/// @param degree  of the polynomials, at least 3
Basis make_basis(Continuity continuity, int degree);

/// A basis at the points of a Gauss rule on [-1, 1].
struct BasisTable {
  Basis basis;
  std::vector<double> points;
  std::vector<double> weights;
  /// values[d][q][i]: d-th derivative of function i at point q
  std::array<std::vector<std::vector<double>>, 3> values;
};

BasisTable make_table(Continuity continuity, int degree);

}  // namespace twum::inline v0_1::stator
