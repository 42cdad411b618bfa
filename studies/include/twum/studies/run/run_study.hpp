// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/results/study_result.hpp>
#include <twum/studies/study/study_file.hpp>

#include <functional>
#include <stop_token>
#include <string>

namespace twum::studies {

struct RunOptions {
  unsigned jobs{0};  ///< threads; 0: one for each processor. The result does not depend on it
  bool fresh{false};  ///< discard what the directory holds of this study and start anew
  std::stop_token stop;  ///< a request ends the run, resumable, with what has been found
  /// Told now and then how far the run is: evaluations, their total (0: unknown), the best so far.
  std::function<void(std::uint64_t done, std::uint64_t total, const std::string& best)> progress;
};

/// Runs a study and keeps everything in a directory: study.yaml (resolved), results.db, results.csv,
/// summary.json. A directory in which the same study was interrupted is gone on with; one that holds
/// a finished result of it answers from there.
/// @throws FileError or InputError for a wrong input or a directory with another study;
///         StoreError if something cannot be written or read back.
StudyResult run_study(const StudyFile& file, const std::string& directory,
                      const RunOptions& options = {});

/// In memory: no directory, nothing kept.
StudyResult run_study(const StudyFile& file, const RunOptions& options = {});

}  // namespace twum::studies
