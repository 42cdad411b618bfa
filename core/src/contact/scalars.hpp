// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/dual.hpp>

namespace twum::contact {

using SpeedDual = Dual<double, 1>;        ///< derivative along the speed
using StateDual = Dual<double, 2>;        ///< derivatives in the layer's state at entry
using NumbersDual = Dual<double, 7>;      ///< derivatives in the seven contact numbers
using NumbersDual2 = Dual<SpeedDual, 7>;  ///< and theirs along the speed

}  // namespace twum::contact

/// The closed list of scalars that the contact runs on.
#define TWUM_FOR_EACH_CONTACT_SCALAR(X) \
  X(double)                             \
  X(SpeedDual)                          \
  X(StateDual)                          \
  X(NumbersDual)                        \
  X(NumbersDual2)
