// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

namespace twum::inline v0_1 {

/// A number that is not known or not defined.
inline constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

}  // namespace twum::inline v0_1
