// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

namespace twum::bench {

/// Wall time of one call [s].
template <typename Work>
double seconds(Work work) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  work();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace twum::bench
