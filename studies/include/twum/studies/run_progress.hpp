// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace twum::inline v0_1::studies {

/// Progress of a study.
struct RunProgress {
  std::uint64_t done{0};  ///< evaluations so far
  /// evaluations of the study, or the budget of a search; 0: not known beforehand
  std::uint64_t total{0};
  bool budget{false};   ///< the total or the share is of a budget: the search usually ends before
  std::string best{};   ///< "peak_power 4.31 W"; empty if there is no best
  std::string stage{};  ///< current stage, such as "run 3"; empty if there are no stages
  double share{
      0};  ///< without a total: of the steps of the study, or of the budget of its present round, 0 to 1

  /// The share that is done, 0 to 1; 0 where it is not known.
  double fraction() const {
    return total > 0 ? static_cast<double>(done) / static_cast<double>(total) : share;
  }
};

}  // namespace twum::inline v0_1::studies
