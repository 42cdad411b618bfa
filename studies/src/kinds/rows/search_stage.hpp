// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace twum::inline v0_1::studies {

/// What a row of a search is. The store keeps it as one number, from which each row can be computed without the others.
struct SearchStage {
  enum class Phase : unsigned char {
    plain,       ///< a search as the study asks for it
    with_nodes,  ///< a search that continues with `auto` and a number of nodes a panel
    robust,      ///< a search under tolerances
    built        ///< the responses of a built motor, which are computed but not stored
  };
  Phase phase{Phase::plain};
  int nodes{0};                ///< of a panel; with_nodes only
  std::uint64_t search{0};     ///< of the study's robust searches, from 0
  std::uint64_t first_run{0};  ///< of the solver in that search

  /// The number in the store: 1900 runs for each count of nodes, 1e8 for each robust search.
  constexpr std::uint64_t number() const {
    switch (phase) {
      case Phase::plain: return first_run;
      case Phase::with_nodes:
        return kWithNodes + kRunsOfNodes * static_cast<std::uint64_t>(nodes) + first_run;
      case Phase::robust: return kRobust + kRunsOfRobust * search + first_run;
      case Phase::built: break;
    }
    return kBuilt;
  }

  static constexpr SearchStage of(std::uint64_t number) {
    if (number == kBuilt) return {Phase::built};
    if (number >= kRobust)
      return {Phase::robust, 0, (number - kRobust) / kRunsOfRobust,
              (number - kRobust) % kRunsOfRobust};
    if (number >= kWithNodes)
      return {Phase::with_nodes, static_cast<int>((number - kWithNodes) / kRunsOfNodes), 0,
              (number - kWithNodes) % kRunsOfNodes};
    return {Phase::plain, 0, 0, number};
  }

 private:
  static constexpr std::uint64_t kWithNodes = 500'000, kRobust = 1'000'000, kBuilt = ~0ull;
  static constexpr std::uint64_t kRunsOfNodes = 1900;  // 256 nodes end before kRobust
  static constexpr std::uint64_t kRunsOfRobust = 100'000'000;
};

}  // namespace twum::inline v0_1::studies
