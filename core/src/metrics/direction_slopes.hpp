// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/scalars.hpp"

#include <twum/core/parameters.hpp>

#include <array>
#include <vector>

namespace twum::inline v0_1::core {

/// How a direction of the model's derivatives moves with a parameter in use; not zero.
struct DirectionSlope {
  int direction;
  std::size_t parameter;
  double value;
};

/// Those of a design, with its plate but without mode_separation, which needs other modes.
std::vector<DirectionSlope> direction_slopes(const MotorDesign& design, bool fixed_static_friction);

/// Derivatives in the parameters in use. A direction without a value does not count where nothing follows from it.
template <int N>
std::array<double, kParameterCount> in_parameters(const Dual<double, N>& dual,
                                                  const std::vector<DirectionSlope>& slopes) {
  std::array<double, kParameterCount> gradient{};
  for (const DirectionSlope& slope : slopes)
    if (slope.direction < N && dual.d[slope.direction] != 0)
      gradient[slope.parameter] += dual.d[slope.direction] * slope.value;
  return gradient;
}

}  // namespace twum::inline v0_1::core
