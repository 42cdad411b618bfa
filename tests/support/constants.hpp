// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <numbers>

/// Constants that tests share: sources of one batch may not give different things the same name.
namespace twum::test {

inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kPi = std::numbers::pi;

}  // namespace twum::test
