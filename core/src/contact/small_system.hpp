// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace twum::inline v0_1::contact {

template <std::size_t N>
using SquareMatrix = std::array<std::array<double, N>, N>;

/// A small matrix as a product of triangular ones, for solving with it. Nothing here asks for memory, and the page has no
/// linear algebra but this.
template <std::size_t N>
class Factors {
 public:
  explicit Factors(const SquareMatrix<N>& m) : m_(m) {
    for (std::size_t i = 0; i < N; ++i) order_[i] = i;
    for (std::size_t k = 0; k < N; ++k) {
      std::size_t pivot = k;
      for (std::size_t i = k + 1; i < N; ++i)
        if (std::fabs(m_[i][k]) > std::fabs(m_[pivot][k])) pivot = i;
      std::swap(m_[k], m_[pivot]), std::swap(order_[k], order_[pivot]);
      inverse_[k] = 1 / m_[k][k];
      for (std::size_t i = k + 1; i < N; ++i) {
        m_[i][k] *= inverse_[k];
        for (std::size_t j = k + 1; j < N; ++j) m_[i][j] -= m_[i][k] * m_[k][j];
      }
    }
  }

  /// x of m x = right; S is double or carries derivatives. Not finite where the matrix is singular.
  template <typename S>
  std::array<S, N> solve(const std::array<S, N>& right) const {
    std::array<S, N> x;
    for (std::size_t i = 0; i < N; ++i) {
      x[i] = right[order_[i]];
      for (std::size_t j = 0; j < i; ++j) x[i] = x[i] - m_[i][j] * x[j];
    }
    for (std::size_t i = N; i-- > 0;) {
      for (std::size_t j = i + 1; j < N; ++j) x[i] = x[i] - m_[i][j] * x[j];
      x[i] = inverse_[i] * x[i];
    }
    return x;
  }

  SquareMatrix<N> inverse() const {
    SquareMatrix<N> r;
    for (std::size_t k = 0; k < N; ++k) {
      std::array<double, N> unit{};
      unit[k] = 1;
      const std::array<double, N> column = solve(unit);
      for (std::size_t i = 0; i < N; ++i) r[i][k] = column[i];
    }
    return r;
  }

 private:
  SquareMatrix<N> m_;
  std::array<double, N> inverse_;
  std::array<std::size_t, N> order_;
};

}  // namespace twum::inline v0_1::contact
