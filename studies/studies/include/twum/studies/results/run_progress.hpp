// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace twum::studies {

/// How far a study is.
struct RunProgress {
  std::uint64_t done{0};   ///< evaluations
  std::uint64_t total{0};  ///< of the study, or the budget of a search; 0: not known beforehand
  bool budget{false};      ///< the total is a budget: the search usually ends before
  std::string best{};      ///< "peak_power 4.31 W"; empty if there is no best
  std::string stage{};     ///< what it is at, such as "run 3"; empty where there are no stages
};

}  // namespace twum::studies
