// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/io/shape.hpp>

#include <utility>

namespace twum::inline v0_1::motors {

/// One row of a measured or computed shape: a radius [m] and R.
Shape<std::pair<double, double>> shape_row();

}  // namespace twum::inline v0_1::motors
