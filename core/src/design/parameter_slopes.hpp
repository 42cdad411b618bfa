// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/parameters.hpp>

#include <cstddef>
#include <vector>

namespace twum::inline v0_1 {

/// An entry of parameter_jacobian() that is not zero: how a parameter's value moves with one in use.
struct ParameterSlope {
  std::size_t value, moved;  ///< of the parameters, as index_of()
  double slope;
};

/// All of them.
std::vector<ParameterSlope> parameter_slopes(const MotorDesign& design, bool fixed_static_friction);

}  // namespace twum::inline v0_1
