// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/first_zero.hpp"

#include <cmath>

namespace twum::test {

/// f = (x - a)^2 (x - b)^2 ... is not what zones have, but its zeros are known: a product of two parabolas
/// about a and b, lifted by `floor`. The bounds hold on 0 .. 2.
struct TwoDips {
  double a, b, floor;
  contact::CurveSample first() const { return sample(0); }
  contact::CurveSample terms(double x) const { return sample(x); }
  contact::CurveSample sample(double x) const {
    const double p = x - a, q = x - b;
    const double f2 = 2 * (p * p + q * q) + 8 * p * q;
    return {p * p * q * q + floor, 2 * p * q * (p + q), f2, 60, 60, 0, 12 * (p + q)};
  }

  /// (x - a) (x - b) = +-sqrt(-floor) where f = 0: the two zeros nearest to a, for a < b and -floor > 0.
  double falling_zero() const { return zero(std::sqrt(-floor)); }
  double rising_zero() const { return zero(-std::sqrt(-floor)); }

 private:
  double zero(double product) const {
    const double half = 0.5 * (b - a);
    return 0.5 * (a + b) - std::sqrt(half * half + product);
  }
};

}  // namespace twum::test
