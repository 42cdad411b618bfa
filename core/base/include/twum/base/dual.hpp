// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace twum::inline v0_1 {

/// A value with its derivatives in N directions: forward-mode differentiation.
///
/// Every operator returns a finished Dual (no expression templates), so `auto` is safe. The value is computed by the
/// same operations in the same order as for T alone: a function gives the same bits on Duals as on T. T is double or,
/// for second derivatives, another Dual.
///
/// A default-constructed Dual is uninitialised; `Dual(x)` is the constant x.
template <typename T, int N>
struct Dual {
  T v;     ///< value
  T d[N];  ///< derivative in each direction

  /// Uninitialised.
  Dual() = default;
  /// A constant: all derivatives are 0.
  Dual(double constant) : v(constant) {  // NOLINT: constants enter formulas as they stand
    for (int i = 0; i < N; ++i) d[i] = T(0.0);
  }

  /// The independent variable of direction i.
  static Dual variable(const T& value, int i) {
    Dual x(0.0);
    x.v = value;
    x.d[i] = T(1.0);
    return x;
  }
};

/// The value of a scalar as a double, without its derivatives.
/// @{
inline double value_of(double x) { return x; }
template <typename T, int N>
double value_of(const Dual<T, N>& x) {
  return value_of(x.v);
}
/// @}

/// How deeply Duals are nested; 0 for a double. Once the value of a root is known, as many Newton steps on Duals give
/// it all its derivatives.
template <typename S>
inline constexpr int kDualDepth = 0;
/// A Dual adds one level to the scalar that it holds.
template <typename T, int N>
inline constexpr int kDualDepth<Dual<T, N>> = 1 + kDualDepth<T>;

/// x with another value and the same derivatives, for a value that is already known more accurately.
/// @{
inline double with_value(double, double value) { return value; }
template <typename T, int N>
Dual<T, N> with_value(Dual<T, N> x, double value) {
  x.v = with_value(x.v, value);
  return x;
}
/// @}

namespace detail {

// f(x) from f and f' at the value.
template <typename T, int N>
Dual<T, N> chain(const Dual<T, N>& x, const T& f, const T& slope) {
  Dual<T, N> r;
  r.v = f;
  for (int i = 0; i < N; ++i) r.d[i] = slope * x.d[i];
  return r;
}

}  // namespace detail

/// Arithmetic by the rules of differentiation; a double is a constant. Costs about 1 + N times the operation on T.
/// Never throws; a division by zero gives what it gives for T.
/// @{
template <typename T, int N>
Dual<T, N> operator-(const Dual<T, N>& a) {
  Dual<T, N> r;
  r.v = -a.v;
  for (int i = 0; i < N; ++i) r.d[i] = -a.d[i];
  return r;
}

template <typename T, int N>
Dual<T, N> operator+(const Dual<T, N>& a, const Dual<T, N>& b) {
  Dual<T, N> r;
  r.v = a.v + b.v;
  for (int i = 0; i < N; ++i) r.d[i] = a.d[i] + b.d[i];
  return r;
}
template <typename T, int N>
Dual<T, N> operator+(Dual<T, N> a, double b) {
  a.v = a.v + b;
  return a;
}
template <typename T, int N>
Dual<T, N> operator+(double a, Dual<T, N> b) {
  b.v = a + b.v;
  return b;
}

template <typename T, int N>
Dual<T, N> operator-(const Dual<T, N>& a, const Dual<T, N>& b) {
  Dual<T, N> r;
  r.v = a.v - b.v;
  for (int i = 0; i < N; ++i) r.d[i] = a.d[i] - b.d[i];
  return r;
}
template <typename T, int N>
Dual<T, N> operator-(Dual<T, N> a, double b) {
  a.v = a.v - b;
  return a;
}
template <typename T, int N>
Dual<T, N> operator-(double a, const Dual<T, N>& b) {
  Dual<T, N> r;
  r.v = a - b.v;
  for (int i = 0; i < N; ++i) r.d[i] = -b.d[i];
  return r;
}

template <typename T, int N>
Dual<T, N> operator*(const Dual<T, N>& a, const Dual<T, N>& b) {
  Dual<T, N> r;
  r.v = a.v * b.v;
  for (int i = 0; i < N; ++i) r.d[i] = a.d[i] * b.v + a.v * b.d[i];
  return r;
}
template <typename T, int N>
Dual<T, N> operator*(const Dual<T, N>& a, double b) {
  Dual<T, N> r;
  r.v = a.v * b;
  for (int i = 0; i < N; ++i) r.d[i] = a.d[i] * b;
  return r;
}
template <typename T, int N>
Dual<T, N> operator*(double a, const Dual<T, N>& b) {
  Dual<T, N> r;
  r.v = a * b.v;
  for (int i = 0; i < N; ++i) r.d[i] = a * b.d[i];
  return r;
}

template <typename T, int N>
Dual<T, N> operator/(const Dual<T, N>& a, const Dual<T, N>& b) {
  Dual<T, N> r;
  r.v = a.v / b.v;
  const T inverse = 1.0 / b.v;
  for (int i = 0; i < N; ++i) r.d[i] = (a.d[i] - r.v * b.d[i]) * inverse;
  return r;
}
template <typename T, int N>
Dual<T, N> operator/(const Dual<T, N>& a, double b) {
  Dual<T, N> r;
  r.v = a.v / b;
  for (int i = 0; i < N; ++i) r.d[i] = a.d[i] / b;
  return r;
}
template <typename T, int N>
Dual<T, N> operator/(double a, const Dual<T, N>& b) {
  Dual<T, N> r;
  r.v = a / b.v;
  const T slope = -(r.v / b.v);
  for (int i = 0; i < N; ++i) r.d[i] = slope * b.d[i];
  return r;
}

template <typename T, int N, typename B>
Dual<T, N>& operator+=(Dual<T, N>& a, const B& b) {
  return a = a + b;
}
template <typename T, int N, typename B>
Dual<T, N>& operator-=(Dual<T, N>& a, const B& b) {
  return a = a - b;
}
template <typename T, int N, typename B>
Dual<T, N>& operator*=(Dual<T, N>& a, const B& b) {
  return a = a * b;
}
/// @}

/// Elementary functions: f(x) with the derivatives f'(x) dx; angles in rad. The derivative of sqrt at 0
/// is infinite.
/// @{

template <typename T, int N>
Dual<T, N> sin(const Dual<T, N>& x) {
  using std::cos, std::sin;
  return detail::chain(x, T(sin(x.v)), T(cos(x.v)));
}
template <typename T, int N>
Dual<T, N> cos(const Dual<T, N>& x) {
  using std::cos, std::sin;
  return detail::chain(x, T(cos(x.v)), T(-sin(x.v)));
}
template <typename T, int N>
Dual<T, N> exp(const Dual<T, N>& x) {
  using std::exp;
  const T f = exp(x.v);
  return detail::chain(x, f, f);
}
template <typename T, int N>
Dual<T, N> log(const Dual<T, N>& x) {
  using std::log;
  return detail::chain(x, T(log(x.v)), T(1.0 / x.v));
}
/// exp(x) - 1 and log(1 + x), accurate where x is small.
template <typename T, int N>
Dual<T, N> expm1(const Dual<T, N>& x) {
  using std::exp, std::expm1;
  return detail::chain(x, T(expm1(x.v)), T(exp(x.v)));
}
template <typename T, int N>
Dual<T, N> log1p(const Dual<T, N>& x) {
  using std::log1p;
  return detail::chain(x, T(log1p(x.v)), T(1.0 / (1.0 + x.v)));
}
template <typename T, int N>
Dual<T, N> sqrt(const Dual<T, N>& x) {
  using std::sqrt;
  const T f = sqrt(x.v);
  return detail::chain(x, f, T(0.5 / f));
}
/// @}

/// The argument of the complex number x + i y [rad].
/// @{
inline double argument(double x, double y) { return std::atan2(y, x); }
template <typename T, int N>
Dual<T, N> argument(const Dual<T, N>& x, const Dual<T, N>& y) {
  Dual<T, N> r;
  r.v = argument(x.v, y.v);
  const T inverse = 1.0 / (x.v * x.v + y.v * y.v);
  for (int i = 0; i < N; ++i) r.d[i] = (x.v * y.d[i] - y.v * x.d[i]) * inverse;
  return r;
}
/// @}

/// Sine and cosine of the same angle.
template <typename S>
struct SinCos {
  S sin;  ///< its sine
  S cos;  ///< its cosine
};

/// Sine and cosine of an angle [rad], with derivatives. A Dual costs one sine and one cosine of T.
/// @{
inline SinCos<double> sincos(double x) { return {std::sin(x), std::cos(x)}; }
template <typename T, int N>
SinCos<Dual<T, N>> sincos(const Dual<T, N>& x) {
  const SinCos<T> at = twum::sincos(x.v);
  return {detail::chain(x, at.sin, at.cos), detail::chain(x, at.cos, T(-at.sin))};
}
/// @}

}  // namespace twum::inline v0_1
