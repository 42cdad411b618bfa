// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/random.hpp>

#include <cmath>
#include <numbers>

namespace twum::test {

/// A number of the standard normal distribution, by Box and Muller.
inline double normal(optim::Random& random) {
  const double radius = std::sqrt(-2 * std::log(1 - random.uniform()));
  return radius * std::cos(2 * std::numbers::pi * random.uniform());
}

}  // namespace twum::test
