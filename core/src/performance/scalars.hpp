// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/scalars.hpp"

namespace twum::performance {

/// Directions of a motor's derivatives: every parameter of the table, and last the speed.
inline constexpr int kDirections = 19;
inline constexpr int kSpeedDirection = 18;

using ModelDual = Dual<double, kDirections>;
using ModelDual2 = Dual<contact::SpeedDual, kDirections>;  ///< and theirs along the speed

}  // namespace twum::performance

/// The closed list of scalars of the motor model, with the scalar of the speed that goes with each.
#define TWUM_FOR_EACH_MODEL_SCALAR(X) \
  X(double, double)                   \
  X(ModelDual, ModelDual)             \
  X(ModelDual2, ModelDual2)
