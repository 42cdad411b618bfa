// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <stop_token>
#include <string>
#include <vector>

namespace twum::inline v0_1::studies {

/// Options of verify_study().
struct VerifyOptions {
  std::uint64_t samples{1000};  ///< stored rows to evaluate again, drawn at random
  std::uint64_t seed{1};        ///< of the draw
  std::stop_token stop{};       ///< ends the verification; it then throws Interrupted
};

/// Comparison of the results in a directory with a new computation. A number holds if it agrees to 1e-12 relative.
struct Verification {
  std::string study;              ///< its name
  std::string kind;               ///< as in `kind:`
  std::uint64_t rows{0};          ///< stored
  std::uint64_t rows_checked{0};  ///< evaluated again
  std::uint64_t rows_skipped{0};  ///< drawn, but cannot be computed independently of other rows
  std::uint64_t designs{0};       ///< of the summary, evaluated again by their metrics' names
  std::uint64_t certificates{0};  ///< optima whose feasibility and stationarity were measured again
  bool answer_checked{false};     ///< whether the answer was derived again from the stored rows
  double deviation{0};  ///< largest relative deviation of a number that holds; 0: equal bit for bit
  std::uint64_t failed{0};              ///< number of checks that fail
  std::vector<std::string> complaints;  ///< the first failures, one line each

  /// True if every check passed.
  bool holds() const noexcept { return failed == 0; }
};

/// Computes the results of a study again from its directory only. Checks random rows, the designs of summary.json,
/// their certificates, the answer that follows from the rows with its counts and notes, study.yaml by its hash,
/// results.csv and the motor files. Does not check report.html, which `twum report` writes again. Changes nothing in
/// the directory.
/// @throws InputError if there is no such directory or no result in it, or a file that the study names has changed since;
/// StoreError if the results cannot be read; Interrupted after a stop request.
Verification verify_study(const std::string& directory, const VerifyOptions& options = {});

}  // namespace twum::inline v0_1::studies
