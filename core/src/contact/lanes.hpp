// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/lane_batch.hpp"
#include "contact/load_shape.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <numbers>
#include <type_traits>

namespace twum::inline v0_1::contact {

/// How many lanes are one vector.
template <LaneWidth W>
inline constexpr int kWidth = W == LaneWidth::avx512     ? 8
                              : W == LaneWidth::avx2     ? 4
                              : W == LaneWidth::baseline ? 2
                                                         : 1;

template <LaneWidth W, typename T>
struct LaneVector {
  using Type [[gnu::vector_size(8 * kWidth<W>)]] = T;
};

/// Conditions in lanes. Both sides of && and || are computed.
template <LaneWidth W>
struct LaneMask {
  using Vector = typename LaneVector<W, std::int64_t>::Type;
  Vector v;  ///< all bits of a lane, or none

  LaneMask(const Vector& lanes = Vector{}) : v(lanes) {}  // NOLINT: comparisons are masks

  friend LaneMask operator!(const LaneMask& a) { return ~a.v; }
  friend LaneMask operator&&(const LaneMask& a, const LaneMask& b) { return a.v & b.v; }
  friend LaneMask operator||(const LaneMask& a, const LaneMask& b) { return a.v | b.v; }
  friend LaneMask& operator&=(LaneMask& a, const LaneMask& b) { return a = a && b; }
  friend LaneMask& operator|=(LaneMask& a, const LaneMask& b) { return a = a || b; }

  friend bool any(const LaneMask& a) {
    std::int64_t bits = 0;
    for (int lane = 0; lane < kWidth<W>; ++lane) bits |= a.v[lane];
    return bits != 0;
  }
};

/// Numbers that go through the same operations, one for each of some contacts. Every lane is computed by the operations of
/// IEEE 754 that are written here, whatever the width and whatever the other lanes: the same bytes on all processors. A width is
/// a type of its own, so that no function that is compiled for it can be taken for that of another.
template <LaneWidth W>
struct Lanes {
  using Mask = LaneMask<W>;
  using Vector = typename LaneVector<W, double>::Type;
  Vector v;

  Lanes() = default;
  Lanes(const Vector& lanes) : v(lanes) {}  // NOLINT: as with doubles
  Lanes(double x) : v(x - Vector{}) {}      // NOLINT: constants enter formulas as they stand
  explicit Lanes(const double* lanes) { std::memcpy(&v, lanes, sizeof v); }
  void store(double* lanes) const { std::memcpy(lanes, &v, sizeof v); }

  friend Lanes operator-(const Lanes& a) { return -a.v; }
  friend Lanes operator+(const Lanes& a, const Lanes& b) { return a.v + b.v; }
  friend Lanes operator-(const Lanes& a, const Lanes& b) { return a.v - b.v; }
  friend Lanes operator*(const Lanes& a, const Lanes& b) { return a.v * b.v; }
  friend Lanes operator/(const Lanes& a, const Lanes& b) { return a.v / b.v; }
  friend Lanes& operator+=(Lanes& a, const Lanes& b) { return a = a + b; }

  friend Mask operator<(const Lanes& a, const Lanes& b) { return a.v < b.v; }
  friend Mask operator>(const Lanes& a, const Lanes& b) { return a.v > b.v; }
  friend Mask operator<=(const Lanes& a, const Lanes& b) { return a.v <= b.v; }
  friend Mask operator>=(const Lanes& a, const Lanes& b) { return a.v >= b.v; }

  friend Lanes max(const Lanes& a, const Lanes& b) { return select(a < b, b, a); }
  friend Lanes min(const Lanes& a, const Lanes& b) { return select(b < a, b, a); }
  friend Lanes fabs(const Lanes& x) { return select(x < 0.0, -x, x); }
  friend Lanes sqrt(const Lanes& x) {
    // GCC makes one instruction of a loop over an array, but not of one over a vector.
    alignas(8 * kWidth<W>) double roots[kWidth<W>];
    x.store(roots);
    for (double& root : roots) root = std::sqrt(root);
    return Lanes(roots);
  }
};

/// a where the condition holds, elsewhere b. Both have been computed.
template <LaneWidth W>
Lanes<W> select(const LaneMask<W>& condition, const std::type_identity_t<Lanes<W>>& a,
                const std::type_identity_t<Lanes<W>>& b) {
  return condition.v ? a.v : b.v;
}

namespace detail {

// The whole number nearest to x: 1.5 2^52 + x has no digits behind the point, and ends in that number. |x| < 2^51.
template <LaneWidth W>
struct Rounded {
  using Integers = typename LaneMask<W>::Vector;
  static constexpr double kNoDigits = 6755399441055744.0;
  Lanes<W> shifted, number;

  explicit Rounded(const Lanes<W>& x) : shifted(x + kNoDigits), number(shifted - kNoDigits) {}

  Integers integer() const { return std::bit_cast<Integers>(shifted.v); }
  // True where n + more has this bit.
  LaneMask<W> has(int bit, int more = 0) const { return ((integer() + more) & bit) != 0; }
};

// c0 + c1 q + c2 q^2 + ... in pairs, then in pairs of pairs: a processor adds them beside one another.
template <LaneWidth W, typename C, std::size_t N>
Lanes<W> polynomial(const std::array<C, N>& c, const Lanes<W>& q) {
  if constexpr (N == 1) {
    return c[0];
  } else {
    std::array<Lanes<W>, (N + 1) / 2> pairs;
    for (std::size_t i = 0; i < N / 2; ++i) pairs[i] = c[2 * i] + c[2 * i + 1] * q;
    if (N % 2 == 1) pairs[N / 2] = c[N - 1];
    return polynomial(pairs, Lanes<W>(q * q));
  }
}

// sign^i / (first + 2 i)!: every other coefficient of a Taylor polynomial.
template <std::size_t N>
constexpr std::array<double, N> taylor(int first, double sign) {
  std::array<double, N> c{};
  double factorial = 1, power = 1;
  for (int k = 2; k <= first; ++k) factorial *= k;
  for (std::size_t i = 0; i < N; ++i) {
    c[i] = power / factorial;
    const int k = first + 2 * static_cast<int>(i);
    factorial *= (k + 1) * (k + 2), power *= sign;
  }
  return c;
}

}  // namespace detail

/// exp(x) for x < 700; 1e-308 for all x below -708. Within 2 units in the last place.
template <LaneWidth W>
Lanes<W> exp(const Lanes<W>& x) {
  constexpr double kLn2High = 0x1.62e42fee00000p-1, kLn2Low = 0x1.a39ef35793c76p-33;
  const Lanes<W> bounded = max(x, Lanes<W>(-708.0));
  const detail::Rounded<W> n(bounded * std::numbers::log2e);
  const Lanes<W> r = bounded - n.number * kLn2High - n.number * kLn2Low;  // |r| < 0.347
  const Lanes<W> q = r * r;
  // cosh and sinh / r; what is left out is below r^14 / 14! = 4e-18
  const Lanes<W> even = detail::polynomial(detail::taylor<7>(0, 1), q);
  const Lanes<W> odd = detail::polynomial(detail::taylor<7>(1, 1), q);
  const Lanes<W> power = std::bit_cast<typename Lanes<W>::Vector>((n.integer() + 1023) << 52);
  return (even + r * odd) * power;
}

/// For |x| <= 1e5, where n has 16 digits; within 4e-16 in absolute terms.
template <LaneWidth W>
SinCos<Lanes<W>> sincos(const Lanes<W>& x) {
  // pi / 2 in three parts, of which the first two have 33 digits: their products with n are exact.
  constexpr double kFirst = 0x1.921fb54400000p+0, kSecond = 0x1.0b4611a600000p-34,
                   kThird = 0x1.3198a2e037073p-69;
  const detail::Rounded<W> n(x * (2 / std::numbers::pi));
  const Lanes<W> r = x - n.number * kFirst - n.number * kSecond - n.number * kThird;
  const Lanes<W> q = r * r;
  // |r| < pi / 4: what is left out is below r^17 / 17! = 5e-17
  const Lanes<W> sine = r * detail::polynomial(detail::taylor<8>(1, -1), q);
  const Lanes<W> cosine = detail::polynomial(detail::taylor<9>(0, -1), q);
  const LaneMask<W> swaps = n.has(1), half_turn = n.has(2), turns_cosine = n.has(2, 1);
  const Lanes<W> s = select(swaps, cosine, sine), c = select(swaps, sine, cosine);
  return {select(half_turn, -s, s), select(turns_cosine, -c, c)};
}

/// The argument of x + i y, or a little less: up to 2e-4, by formula 4.4.49 of Abramowitz and Stegun, Handbook of Mathematical
/// Functions, which is right to 1e-5.
template <LaneWidth W>
Lanes<W> least_argument(const Lanes<W>& x, const Lanes<W>& y) {
  using std::numbers::pi;
  const Lanes<W> along = fabs(x), across = fabs(y);
  const Lanes<W> t = min(along, across) / max(max(along, across), Lanes<W>(1e-300)), q = t * t;
  const Lanes<W> eighth =
      t * (0.9998660 + q * (-0.3302995 + q * (0.1801410 + q * (-0.0851330 + q * 0.0208351))));
  const Lanes<W> quarter = select(across > along, 0.5 * pi - eighth, eighth);
  const Lanes<W> half = select(x < 0.0, pi - quarter, quarter);
  return select(y < 0.0, -half, half) - 1e-4;
}

template <LaneWidth W>
Trig<Lanes<W>> trig_of(const SinCos<Lanes<W>>& a) {
  return {a.sin, a.cos, select(a.cos > 0.0, a.sin * a.sin / (1.0 + a.cos), 1.0 - a.cos)};
}
template <LaneWidth W>
Trig<Lanes<W>> trig(const Lanes<W>& theta) {
  return trig_of(sincos(theta));
}

template <LaneWidth W>
Lanes<W> load_shape(const Lanes<W>& theta, const Trig<Lanes<W>>& at) {
  const auto large = fabs(theta) > kLoadSeriesReach;
  return select(large, at.sin - theta * at.cos, load_shape_series(theta));
}

}  // namespace twum::inline v0_1::contact
