// SPDX-License-Identifier: Apache-2.0
#include <twum/core/normal_contact.hpp>

#include "contact/load_shape.hpp"

#include <cmath>
#include <numbers>

namespace twum::inline v0_1 {
namespace {

constexpr double kPi = std::numbers::pi;
// of the angle, and of what it lacks of pi; what a step leaves is its third power
constexpr double kLastStep = 1e-5;
constexpr double kRounding = 5e-16;  // of the load

// The sum of c[k] x^k.
template <std::size_t N>
double polynomial(const double (&c)[N], double x) {
  double sum = c[N - 1];
  for (std::size_t k = N - 1; k-- > 0;) sum = sum * x + c[k];
  return sum;
}

// Right to 3e-6 of the angle, and of what it lacks of pi: Chebyshev expansions of t / cbrt(3 load), the limit of small loads, in
// its square, and of (pi - t) / sqrt(2 (pi - load) / pi), the limit near pi, in the root. The
// coefficients are those of chebyfit() of mpmath with 30 digits.
double first_angle(double load) {
  constexpr double kSmall[] = {0.9999989725830135,     0.033372953638704905,
                               0.003008644662465816,   0.0009920292630289807,
                               -0.0005519896500088539, 0.0003584498736136516,
                               -9.719073129306642e-05, 1.1957178401352147e-05};
  constexpr double kNearPi[] = {1.0000011621396445,  0.10597143941036456, 0.07221332080531477,
                                0.00950251876687028, 0.06377960694786443, -0.0625830734712874,
                                0.046554388952048484};
  if (load < 2.0) {
    const double c = std::cbrt(3 * load);
    return c * polynomial(kSmall, c * c);
  }
  const double u = std::sqrt(2 * (kPi - load) / kPi);
  return kPi - u * polynomial(kNearPi, u);
}

}  // namespace

// Halley's method for sin t - t cos t = load. A bracket guards every step.
double contact_half_angle(double load) {
  if (!(load > 0)) return 0;
  double low = 0, high = kPi, t = first_angle(load);
  for (int i = 0; i < 60; ++i) {
    const double s = std::sin(t), c = std::cos(t);
    const double shape = t > contact::kLoadSeriesReach ? s - t * c : contact::load_shape_series(t);
    const double excess = shape - load, slope = t * s;
    if (std::fabs(excess) <= kRounding * load) break;
    (excess > 0 ? high : low) = t;
    const double newton = excess / slope;
    double next = t - newton / (1 - 0.5 * newton * (s + t * c) / slope);
    if (!(next >= low && next <= high)) next = 0.5 * (low + high);
    const double step = std::fabs(next - t);
    t = next;
    if (step <= kLastStep * std::fmin(t, kPi - t)) break;
  }
  return t;
}

}  // namespace twum::inline v0_1
