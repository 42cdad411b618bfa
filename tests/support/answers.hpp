// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstdio>

// What twum_core_answers writes: pairs of doubles, value and allowed difference.
namespace twum::test {

inline void put(double value, double allowed) {
  const std::array<double, 2> pair{value, allowed};
  std::fwrite(pair.data(), sizeof(double), pair.size(), stdout);
}

/// A number to a share of itself and a share of the scale on which rounding counts.
inline void put_number(double value, double share, double rounding) {
  put(value, share * std::abs(value) + rounding);
}

template <typename Status>
void put_status(Status status) {
  put(static_cast<double>(status), 0);
}

}  // namespace twum::test
