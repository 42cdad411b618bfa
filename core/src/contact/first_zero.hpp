// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace twum::contact {

/// A function at one place, with what is known of it from there to the end of the zone.
struct CurveSample {
  double f, f1, f2;  ///< value and two derivatives
  double l2, l3;     ///< bounds of |f''| and |f'''| from here on
  double skip;       ///< f has no zero for at least this far, by another bound; 0 if unknown
  double f3;         ///< third derivative
};

/// What is known exactly of f at the start of a zone.
enum class StartOrder : unsigned char {
  positive,    ///< f > 0
  zero,        ///< f = 0, rising
  double_zero  ///< f = f' = 0, f'' > 0
};

inline constexpr double kNoZero = std::numeric_limits<double>::infinity();

/// The positive root of a + b t - c t^2 / 2 with a >= 0 < c, without cancellation.
inline double positive_root(double a, double b, double c) {
  const double root = std::sqrt(b * b + 2 * c * a);
  return b > 0 ? (b + root) / c : 2 * a / (root - b);
}

/// Step over which f stays positive by the bound l2 (E3.1).
inline double quadratic_step(const CurveSample& c) { return positive_root(c.f, c.f1, c.l2); }

/// The same by the bound l3 for an f that falls (E3.2), from a step that is known to be safe: the cubic
/// q = f + f' t + min(f'', 0) t^2 / 2 - l3 t^3 / 6 is concave, so between a place where it is positive
/// and its tangent's zero, where it is not, it lies above the chord, whose zero is safe again.
inline double falling_step(const CurveSample& c, double t) {
  const double a = c.f2 < 0 ? c.f2 / 2 : 0, b = c.l3 / 6;
  const double q = c.f + t * (c.f1 + t * (a - t * b)), slope = c.f1 + t * (2 * a - 3 * t * b);
  if (!(q > 0 && slope < 0)) return t;
  const double over = t - q / slope, q_over = c.f + over * (c.f1 + over * (a - over * b));
  return q_over < 0 ? t + (over - t) * q / (q - q_over) : t;
}

/// The same for an f that rises (E3.7): the cubic q = f + f' t + f'' t^2 / 2 - l3 t^3 / 6 up to its top and
/// beyond. NaN where q is flat there.
inline double rising_step(const CurveSample& c) {
  const double top = positive_root(c.f1, c.f2, c.l3), bend = c.l3 * top - c.f2;
  const double q = c.f + top * (c.f1 + top * (c.f2 / 2 - top * c.l3 / 6));
  const double down = std::sqrt(2 * q / bend);
  return top + down / std::sqrt(1 + c.l3 * down / (3 * bend));
}

/// Step over which f stays positive from an event where it is zero (E3.3), with a little to spare (E3.4):
/// the next sample is to be above zero.
inline double leaving_step(double f1, const CurveSample& c) {
  return 0.95 * std::max(2 * f1 / c.l2, positive_root(f1, c.f2 / 2, c.l3 / 3));
}

/// Step over which f stays positive.
inline double zero_free_step(const CurveSample& c, StartOrder order) {
  if (order == StartOrder::double_zero) return leaving_step(0, c);
  if (order == StartOrder::zero) return leaving_step(c.f1, c);
  const double t = quadratic_step(c);
  return c.f1 < 0 ? falling_step(c, t) : std::max(t, rising_step(c));
}

/// Length over which f is sure to fall through zero once, and monotonically: a little past the zero of
/// its parabola (E3.5). 0 if that cannot be told.
inline double zero_bracket(const CurveSample& c) {
  const double square = c.f1 * c.f1 - 2 * c.f2 * c.f;
  // No zero lies before f / |f'| unless f bends down; where l3 may turn the slope by then, none is sure.
  const bool hopeless = c.f2 > 0 && c.l3 * c.f * c.f > -2 * c.f1 * c.f1 * c.f1;
  if (!(c.f1 < 0 && square > 0) || hopeless) return 0;
  const double t = 1.1 * 2 * c.f / (std::sqrt(square) - c.f1);
  const bool falls = c.f1 + std::max(c.f2, 0.0) * t + c.l3 * t * t / 2 < 0;
  return falls && c.f + t * (c.f1 + t * (c.f2 / 2 + c.l3 * t / 6)) < 0 ? t : 0;
}

/// Householder's step of third order (E3.8), which takes f, f', f'' and f''' and one division. Newton's step
/// where the bends are too strong for that.
inline double householder_step(const CurveSample& c) {
  const double bend = 0.5 * c.f * c.f2, numerator = c.f1 * c.f1 - bend;
  const double straight = c.f1 * numerator, bent = c.f * c.f * c.f3 * (1.0 / 6) - c.f1 * bend;
  const bool tame = std::fabs(bent) < 0.5 * std::fabs(straight);
  return tame ? -c.f * numerator / (straight + bent) : -c.f / c.f1;
}

/// The error of such a step is of fourth order in its length. It leaves nothing that counts where the
/// step's share of the bends is below 1e-4.
/// @param l3  bound of |f'''|
inline bool is_last_step(const CurveSample& c, double l3, double step) {
  const double slope = std::fabs(c.f1);
  return std::fabs(step * c.f2) < 1e-4 * slope && l3 * step * step < 1e-8 * slope;
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
      if (const double reach = zero_bracket(c); reach > 0) {
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

}  // namespace twum::contact
