// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace twum::studies {

/// Progress of a study.
struct RunProgress {
  std::uint64_t done{0};  ///< evaluations so far
  /// evaluations of the study, or the budget of a search; 0: not known beforehand
  std::uint64_t total{0};
  bool budget{false};   ///< the total is a budget: the search usually ends before
  std::string best{};   ///< "peak_power 4.31 W"; empty if there is no best
  std::string stage{};  ///< current stage, such as "run 3"; empty if there are no stages
};

}  // namespace twum::studies
