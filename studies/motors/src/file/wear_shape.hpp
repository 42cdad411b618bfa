// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/motor_design.hpp>
#include <twum/io/shape.hpp>

#include <vector>

namespace twum::inline v0_1::motors {

/// The list `wear.until`: limits that end a life, each of one metric and a number.
const Shape<std::vector<WearLimit>>& until_shape();

/// The word `wear.profile`.
Shape<WearProfile> wear_profile_shape();

}  // namespace twum::inline v0_1::motors
