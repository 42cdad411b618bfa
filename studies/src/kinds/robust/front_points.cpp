// SPDX-License-Identifier: Apache-2.0
#include "kinds/robust/front_points.hpp"

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::studies {

std::vector<std::size_t> ends_of(const ParetoResult& result) {
  std::vector<std::size_t> ends;
  for (std::size_t k = 0; k < result.goals.size(); ++k) {
    const auto worse = [&](const auto& a, const auto& b) {
      return result.goals[k].maximize ? a.goals[k] > b.goals[k] : a.goals[k] < b.goals[k];
    };
    const auto best = std::min_element(result.front.begin(), result.front.end(), worse);
    ends.push_back(static_cast<std::size_t>(best - result.front.begin()));
  }
  return ends;
}

// Goals as losses between 0 at the best and 1 at the worst of the front. On the line (plane) through
// the ends they add up to 1; the knee is where they add up to the least.
std::size_t knee_of(const ParetoResult& result) {
  std::size_t knee = 0;
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < result.front.size(); ++i) {
    double sum = 0;
    for (std::size_t k = 0; k < result.goals.size(); ++k) {
      const auto [low, high] = std::minmax_element(
          result.front.begin(), result.front.end(),
          [k](const auto& a, const auto& b) { return a.goals[k] < b.goals[k]; });
      const double span = high->goals[k] - low->goals[k];
      const double best = (result.goals[k].maximize ? high : low)->goals[k];
      if (span > 0) sum += std::fabs(result.front[i].goals[k] - best) / span;
    }
    if (sum < least) {
      least = sum;
      knee = i;
    }
  }
  return knee;
}

}  // namespace twum::inline v0_1::studies
