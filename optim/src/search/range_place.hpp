// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/problem.hpp>

#include <cmath>

namespace twum::inline v0_1::optim {

/// Place of a value in its variable's range by the variable's scale: 0 at the lower end, 1 at the upper one; 0 in a range of one value.
inline double place_in_range(const Variable& v, double x) {
  if (v.lower == v.upper) return 0.0;
  return v.scale == Scale::log ? std::log(x / v.lower) / std::log(v.upper / v.lower)
                               : (x - v.lower) / (v.upper - v.lower);
}

/// The value at a place; whole numbers are not rounded.
inline double value_in_range(const Variable& v, double place) {
  return v.scale == Scale::log ? v.lower * std::pow(v.upper / v.lower, place)
                               : v.lower + place * (v.upper - v.lower);
}

}  // namespace twum::inline v0_1::optim
