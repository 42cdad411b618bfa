// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace twum::studies {

/// What to look at again.
struct VerifyOptions {
  std::uint64_t samples{1000};  ///< stored rows to evaluate again, drawn at random
  std::uint64_t seed{1};        ///< of the draw
};

/// What became of the results in a directory when they were computed again. Numbers hold if they are
/// equal to 1e-12 of their size.
struct Verification {
  std::string study;              ///< its name
  std::string kind;               ///< as in `kind:`
  std::uint64_t rows{0};          ///< stored
  std::uint64_t rows_checked{0};  ///< evaluated again
  std::uint64_t rows_skipped{0};  ///< drawn, but not to be computed by themselves
  std::uint64_t designs{0};       ///< of the summary, evaluated again by their metrics' names
  std::uint64_t certificates{0};  ///< optima whose feasibility and stationarity were measured again
  bool answer_checked{false};     ///< whether the answer was derived again from the stored rows
  double deviation{0};      ///< largest relative one of a number that holds; 0: equal to the bit
  std::uint64_t failed{0};  ///< things that do not hold
  std::vector<std::string> complaints;  ///< the first of them, a line each

  /// True if everything that was looked at holds.
  bool holds() const noexcept { return failed == 0; }
};

/// Computes the results of a study again, from its directory alone: random rows, the designs of
/// summary.json, their certificates, and the answer as it follows from the rows, with the counts and
/// notes beside it; study.yaml against its hash; results.csv and motor files against these. Not report.html, which `twum report` makes anew. Changes nothing there.
/// @throws InputError if there is no such directory or no result in it; StoreError if it cannot be read.
Verification verify_study(const std::string& directory, const VerifyOptions& options = {});

}  // namespace twum::studies
