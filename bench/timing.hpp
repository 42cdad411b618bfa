// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
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

/// Time of one call [s], as the best of a few batches that are long against the clock's grain.
template <typename Call>
double seconds_per_call(Call call, int batch = 20, int repeats = 5) {
  double best = 1e9;
  for (int r = 0; r < repeats; ++r) {
    const double all = seconds([&] {
      for (int i = 0; i < batch; ++i) call();
    });
    best = std::min(best, all / batch);
  }
  return best;
}

}  // namespace twum::bench
