// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "heat/network.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

/// Matrices of three rows and columns.
namespace twum::inline v0_1::core {

using Vector3 = Masses<double>;
using Matrix3 = Rows3<double, kMasses>;

inline constexpr Matrix3 kIdentity3{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

inline Vector3 operator*(const Matrix3& a, const Vector3& x) {
  return {dot(a[0], x), dot(a[1], x), dot(a[2], x)};
}

inline Matrix3 operator*(const Matrix3& a, const Matrix3& b) {
  Matrix3 c{};
  for (std::size_t i = 0; i < kMasses; ++i)
    for (std::size_t j = 0; j < kMasses; ++j)
      for (std::size_t k = 0; k < kMasses; ++k) c[i][j] += a[i][k] * b[k][j];
  return c;
}

/// a + s b
inline Matrix3 plus(const Matrix3& a, double s, const Matrix3& b) {
  Matrix3 c = a;
  for (std::size_t i = 0; i < kMasses; ++i)
    for (std::size_t j = 0; j < kMasses; ++j) c[i][j] += s * b[i][j];
  return c;
}
inline Vector3 plus(const Vector3& a, double s, const Vector3& b) {
  return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]};
}

inline double largest(const Vector3& x) {
  return std::max({std::fabs(x[0]), std::fabs(x[1]), std::fabs(x[2])});
}

/// Cofactors of the first row.
inline Vector3 cofactors(const Matrix3& a) {
  return {a[1][1] * a[2][2] - a[1][2] * a[2][1], a[1][2] * a[2][0] - a[1][0] * a[2][2],
          a[1][0] * a[2][1] - a[1][1] * a[2][0]};
}

inline double determinant(const Matrix3& a) { return dot(a[0], cofactors(a)); }

/// By Cramer's rule; infinite or NaN where the matrix is singular.
inline Matrix3 inverse(const Matrix3& a) {
  const double det = determinant(a);
  Matrix3 b;
  for (std::size_t i = 0; i < kMasses; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const Vector3 row = cofactors({{a[i], a[j], a[k]}});
    for (std::size_t c = 0; c < kMasses; ++c) b[c][i] = row[c] / det;
  }
  return b;
}

/// Eigenvalues: three real ones, or one and a pair.
struct Eigenvalues {
  Vector3 real;         ///< of a pair the last two
  double imaginary{0};  ///< of the pair
};

/// Zeros of the characteristic polynomial by Cardano's and Viete's formulas, and two steps of Newton's method.
inline Eigenvalues eigenvalues(const Matrix3& a) {
  const double trace = a[0][0] + a[1][1] + a[2][2];
  const double minors = a[0][0] * a[1][1] - a[0][1] * a[1][0] + a[0][0] * a[2][2] -
                        a[0][2] * a[2][0] + a[1][1] * a[2][2] - a[1][2] * a[2][1];
  const double det = determinant(a);
  const auto refined = [&](double x) {
    for (int i = 0; i < 2; ++i) {
      const double slope = (3 * x - 2 * trace) * x + minors;
      const double step = (((x - trace) * x + minors) * x - det) / slope;
      if (std::isfinite(step)) x -= step;
    }
    return x;
  };
  const double third = trace / 3, q = third * third - minors / 3;
  const double r = -third * third * third + third * minors / 2 - det / 2;
  if (r * r < q * q * q) {
    const double angle = std::acos(std::clamp(r / std::sqrt(q * q * q), -1.0, 1.0));
    Eigenvalues found{};
    for (std::size_t k = 0; k < 3; ++k)
      found.real[k] = refined(
          third -
          2 * std::sqrt(q) * std::cos((angle + 2 * std::numbers::pi * static_cast<double>(k)) / 3));
    return found;
  }
  const double s = -std::copysign(std::cbrt(std::fabs(r) + std::sqrt(r * r - q * q * q)), r);
  const double t = s == 0 ? 0 : q / s;
  return {{refined(third + s + t), third - (s + t) / 2, third - (s + t) / 2},
          std::sqrt(3.0) / 2 * std::fabs(s - t)};
}

/// The largest real part.
inline double abscissa(const Eigenvalues& e) { return std::max({e.real[0], e.real[1], e.real[2]}); }

/// exp(A) and the functions phi_k(A), phi_k(z) = (phi_(k-1)(z) - 1 / (k-1)!) / z with phi_0 = exp, of which phi is the first. By
/// Taylor's series of A / 2^n and phi_k(2z) = 2^-k (exp(z) phi_k(z) + sum over j = 1 to k of phi_j(z) / (k - j)!).
struct Exponential {
  Matrix3 exp, phi, phi2, phi3;
};
inline Exponential exponential(Matrix3 a) {
  double size = 0;
  for (const Vector3& row : a) size = std::max(size, largest(row));
  int halvings = 0;
  while (size > 0.25) size /= 2, ++halvings;
  a = plus(Matrix3{}, std::ldexp(1, -halvings), a);
  Matrix3 phi3 = plus(Matrix3{}, 1.0 / 6, kIdentity3), term = phi3;
  for (int k = 4; k <= 16; ++k) {  // (3 / 4)^14 / 15! is 1e-14 of the sum
    term = plus(Matrix3{}, 1.0 / k, term * a);
    phi3 = plus(phi3, 1, term);
  }
  Matrix3 phi2 = plus(a * phi3, 0.5, kIdentity3), phi = plus(a * phi2, 1, kIdentity3),
          exp = plus(a * phi, 1, kIdentity3);
  for (; halvings > 0; --halvings) {
    phi3 = plus(Matrix3{}, 0.125, plus(plus(plus(exp * phi3, 0.5, phi), 1, phi2), 1, phi3));
    phi2 = plus(Matrix3{}, 0.25, plus(plus(exp * phi2, 1, phi), 1, phi2));
    phi = plus(Matrix3{}, 0.5, phi * plus(exp, 1, kIdentity3));
    exp = exp * exp;
  }
  return {exp, phi, phi2, phi3};
}

}  // namespace twum::inline v0_1::core
