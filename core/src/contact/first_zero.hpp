// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/scalars.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace twum::inline v0_1::contact {

/// A function at one place, with what is known of it from there to the end of the zone.
template <typename S>
struct SampleOf {
  S f, f1, f2;  ///< value and two derivatives
  S l2, l3;     ///< bounds of |f''| and |f'''| from here on
  S skip;       ///< f has no zero for at least this far, by another bound; 0 if unknown
  S f3;         ///< third derivative
};
using CurveSample = SampleOf<double>;

/// What is known exactly of f at the start of a zone.
enum class StartOrder : unsigned char {
  positive,    ///< f > 0
  zero,        ///< f = 0, rising
  double_zero  ///< f = f' = 0, f'' > 0
};

inline constexpr double kNoZero = std::numeric_limits<double>::infinity();

/// The positive root of a + b t - c t^2 / 2 with a >= 0 < c, without cancellation.
template <typename S>
S positive_root(const S& a, const S& b, const S& c) {
  using std::sqrt;
  const S root = sqrt(b * b + 2.0 * c * a);
  return select(b > 0.0, b + root, 2.0 * a) / select(b > 0.0, c, root - b);
}

/// Step over which f stays positive by the bound l2 (E3.1).
template <typename S>
S quadratic_step(const SampleOf<S>& c) {
  return positive_root(c.f, c.f1, c.l2);
}

/// The same by the bound l3 for an f that falls (E3.2), from a step that is known to be safe: the cubic
/// q = f + f' t + min(f'', 0) t^2 / 2 - l3 t^3 / 6 is concave, so between a place where it is positive
/// and its tangent's zero, where it is not, it lies above the chord, whose zero is safe again.
template <typename S>
S falling_step(const SampleOf<S>& c, const S& t) {
  const S a = select(c.f2 < 0.0, c.f2 / 2.0, 0.0), b = c.l3 / 6.0;
  const S q = c.f + t * (c.f1 + t * (a - t * b)), slope = c.f1 + t * (2.0 * a - 3.0 * t * b);
  const S over = t - q / slope, q_over = c.f + over * (c.f1 + over * (a - over * b));
  const auto safe = q > 0.0 && slope < 0.0 && q_over < 0.0;
  return select(safe, t + (over - t) * q / (q - q_over), t);
}

/// The same for an f that rises (E3.7): the cubic q = f + f' t + f'' t^2 / 2 - l3 t^3 / 6 up to its top and
/// beyond. NaN where q is flat there.
template <typename S>
S rising_step(const SampleOf<S>& c) {
  using std::sqrt;
  const S top = positive_root(c.f1, c.f2, c.l3), bend = c.l3 * top - c.f2;
  const S q = c.f + top * (c.f1 + top * (c.f2 / 2.0 - top * c.l3 / 6.0));
  const S down = sqrt(S(2.0 * q / bend));
  return top + down / sqrt(S(1.0 + c.l3 * down / (3.0 * bend)));
}

/// Step over which f stays positive from an event where it is zero (E3.3), with a little to spare (E3.4):
/// the next sample is to be above zero.
template <typename S>
S leaving_step(const S& f1, const SampleOf<S>& c) {
  using std::max;
  return 0.95 * max(S(2.0 * f1 / c.l2), positive_root(f1, S(c.f2 / 2.0), S(c.l3 / 3.0)));
}

/// Step over which f stays positive.
inline double zero_free_step(const CurveSample& c, StartOrder order) {
  if (order == StartOrder::double_zero) return leaving_step(0.0, c);
  if (order == StartOrder::zero) return leaving_step(c.f1, c);
  const double t = quadratic_step(c);
  return c.f1 < 0 ? falling_step(c, t) : std::max(t, rising_step(c));
}

/// Length over which f is sure to fall through zero once, and monotonically: a little past the zero of
/// its parabola (E3.5). 0 if that cannot be told.
template <typename S>
inline S zero_bracket(const SampleOf<S>& c) {
  using std::max, std::sqrt;
  const S t = 1.1 * 2.0 * c.f / (sqrt(S(c.f1 * c.f1 - 2.0 * c.f2 * c.f)) - c.f1);
  const auto falls = c.f1 < 0.0 && c.f1 + max(c.f2, S(0.0)) * t + c.l3 * t * t / 2.0 < 0.0;
  return select(falls && c.f + t * (c.f1 + t * (c.f2 / 2.0 + c.l3 * t / 6.0)) < 0.0, t, 0.0);
}

/// False if zero_bracket() surely is 0: no zero lies before f / |f'| unless f bends down, and where l3 may turn the slope by
/// then, none is sure.
inline bool may_be_bracketed(const CurveSample& c) {
  return c.f1 < 0 && !(c.f2 > 0 && c.l3 * c.f * c.f > -2 * c.f1 * c.f1 * c.f1);
}

/// Householder's step of third order (E3.8), which takes f, f', f'' and f''' and one division. Newton's step
/// where the bends are too strong for that.
template <typename S>
S householder_step(const SampleOf<S>& c) {
  using std::fabs;
  const S bend = 0.5 * c.f * c.f2, numerator = c.f1 * c.f1 - bend;
  const S straight = c.f1 * numerator, bent = c.f * c.f * c.f3 * (1.0 / 6) - c.f1 * bend;
  const auto tame = fabs(bent) < 0.5 * fabs(straight);
  return -c.f * select(tame, numerator, 1.0) / select(tame, straight + bent, c.f1);
}

/// The error of such a step is of fourth order in its length. It leaves nothing that counts where the
/// step's share of the bends is below 1e-4.
/// @param l3  bound of |f'''|
template <typename S>
auto is_last_step(const SampleOf<S>& c, const S& l3, const S& step) {
  using std::fabs;
  const S slope = fabs(c.f1);
  return fabs(step * c.f2) < 1e-4 * slope && l3 * step * step < 1e-8 * slope;
}

/// The only zero between low, where f > 0, and high, where f < 0, by Householder's steps from x in between,
/// with the sample there and its bounds.
template <typename Curve>
double polish_zero(const Curve& curve, double low, double high, double x,
                   const CurveSample& there) {
  CurveSample c = there;
  for (int i = 0; i < 100; ++i) {
    (c.f > 0 ? low : high) = x;
    double next = x + householder_step(c);
    const bool inside = next >= low && next <= high;
    if (inside && is_last_step(c, there.l3, next - x)) return next;
    if (!inside) next = 0.5 * (low + high);
    if (next == x) return x;
    x = next;
    c = curve.terms(x);
    if (c.f == 0) return x;
  }
  return x;
}

/// A zero near x, first or not. NaN if few steps do not lead to one on (0, length).
template <typename Curve>
double followed_zero(const Curve& curve, double x, double length) {
  constexpr double kShort = 1e-3;  // its fourth power is lost in what followed zeros are used for
  for (int i = 0; i < 4 && x > 0 && x < length; ++i) {
    const CurveSample c = curve.terms(x);
    const double step = householder_step(c);
    x += step;
    const bool short_step =
        std::fabs(step) < kShort * x && std::fabs(step * c.f2) < kShort * std::fabs(c.f1);
    if (short_step && x < length) return x;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

/// A zero of which nothing is known but that it is one.
struct KnownZero {
  double zero{kNoZero};           ///< kNoZero if none is known
  double place{0}, f1{0}, f2{0};  ///< a place close to it, with f' < 0 and f'' there

  /// True if it is the first zero from x on (E3.6).
  /// @param c  sample with bounds that hold from x on
  bool is_first_from(double x, const CurveSample& c) const {
    if (zero == kNoZero) return false;
    const double bend = std::fabs(f2) + std::sqrt(f2 * f2 - 2 * c.l3 * f1);
    const double falling = std::max(-f1 / c.l2, -2 * f1 / bend);
    return x >= place - falling && std::fabs(zero - place) < falling;
  }
};

/// Nothing is known.
struct NoKnownZero {
  static constexpr double zero = kNoZero;
  static bool is_first_from(double /*x*/, const CurveSample& /*c*/) { return false; }
};

/// The zero near x, if few steps of polish_zero() lead there.
template <typename Curve>
KnownZero known_zero(const Curve& curve, double x, double length) {
  for (int i = 0; i < 3 && x > 0 && x < length; ++i) {
    const CurveSample c = curve.sample(x);
    const double zero = x + householder_step(c);
    if (!(c.f1 < 0 && zero > 0 && zero < length)) break;
    if (is_last_step(c, c.l3, zero - x)) return {zero, x, c.f1, c.f2};
    x = zero;
  }
  return {};
}

/// First zero of a curve on (0, length), or kNoZero; none can be missed: the march takes only steps
/// that are proven free of zeros until one is bracketed (docs/theory/events.md).
///
/// @param work   counts samples; past `limit` the march gives up and returns NaN.
/// @param known  a zero to stop at once it is proven to be the first
template <typename Curve, typename Known = NoKnownZero>
double first_zero(const Curve& curve, double length, StartOrder order, long& work, long limit,
                  const Known& known = {}) {
  double x = 0;
  CurveSample c = curve.first();
  while (++work <= limit) {
    if (order == StartOrder::positive) {
      if (!(c.f > 0)) return x;
      if (known.zero != kNoZero && known.is_first_from(x + std::max(quadratic_step(c), c.skip), c))
        return known.zero;
      if (const double reach = may_be_bracketed(c) ? zero_bracket(c) : 0; reach > 0) {
        const double zero = polish_zero(curve, x, x + reach, x, c);
        return zero < length ? zero : kNoZero;
      }
    }
    if (c.skip >= length - x) return kNoZero;
    const double step = std::max(zero_free_step(c, order), c.skip);
    if (!(step > 0)) return x;
    x += step;
    if (known.is_first_from(x, c)) return known.zero;
    if (x >= length) return kNoZero;
    order = StartOrder::positive;
    c = curve.sample(x);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace twum::inline v0_1::contact
